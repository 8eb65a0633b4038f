// stills.js CHROMIUM GALLERY: takes a picture of each motion in GALLERY for the index, without a network. A page keeps its picture
// until its motion is made again.
import fs from 'node:fs'
import os from 'node:os'
import path from 'node:path'
import { pathToFileURL } from 'node:url'
import { chromium } from 'playwright-core'

const [browserPath, gallery] = process.argv.slice(2)
const moment = 0.35 // of the motion

function isOld(folder) {
  const motion = path.join(folder, 'motion.html'), still = path.join(folder, 'still.jpg')
  return fs.existsSync(motion) && !(fs.existsSync(still) && fs.statSync(still).mtimeMs > fs.statSync(motion).mtimeMs)
}

const folders = fs.readdirSync(gallery).map(each => path.resolve(gallery, each)).filter(isOld)
const home = fs.mkdtempSync(path.join(os.tmpdir(), 'gallery-'))
const context = await chromium.launchPersistentContext(home, {
  executablePath: browserPath, offline: true, reducedMotion: 'reduce',
  viewport: { width: 660, height: 500 }, deviceScaleFactor: 480 / 660, // wide enough for the layout of a window
  args: ['--no-sandbox', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
    '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist']
})
context.setDefaultTimeout(120_000)
try {
  const page = await context.newPage()
  for (const folder of folders) {
    await page.goto(pathToFileURL(path.join(folder, 'motion.html')).href)
    await page.waitForSelector('#view canvas')
    await page.evaluate(part => {
      const time = document.getElementById('time')
      time.value = Number(time.min) + part * (Number(time.max) - Number(time.min))
      time.dispatchEvent(new Event('input', { bubbles: true }))
      const view = document.getElementById('view')
      for (const each of document.querySelectorAll('body *'))
        if (!view.contains(each) && !each.contains(view)) each.style.visibility = 'hidden'
    }, moment)
    await page.waitForTimeout(400)
    await page.locator('#view canvas').screenshot({ path: path.join(folder, 'still.jpg'), type: 'jpeg', quality: 72 })
  }
} finally {
  await context.close()
  fs.rmSync(home, { recursive: true, force: true })
}
