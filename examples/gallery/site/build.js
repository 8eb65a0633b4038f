// Makes the pages of the gallery: build.js GALLERY SOURCES TIMES. GALLERY holds a folder for each page, with the parts
// that its program wrote; SOURCES is the folder examples/, and TIMES has the seconds of the compiler. The pages need
// neither a network nor a script.
import fs from 'node:fs'
import path from 'node:path'
import { createRequire } from 'node:module'
import { fileURLToPath } from 'node:url'
import hljs from 'highlight.js/lib/core'
import cpp from 'highlight.js/lib/languages/cpp'
import katex from 'katex'
import nunjucks from 'nunjucks'

const here = path.dirname(fileURLToPath(import.meta.url))
const [gallery, sources, times] = process.argv.slice(2).map(each => path.resolve(each))
const chapters = JSON.parse(fs.readFileSync(path.join(here, 'chapters.json'), 'utf8'))
hljs.registerLanguage('cpp', cpp)
const templates = new nunjucks.Environment(new nunjucks.FileSystemLoader(here), { autoescape: true, throwOnUndefined: true })

function math(latex, displayed = false) {
  const html = katex.renderToString((displayed ? '\\displaystyle ' : '') + latex, { throwOnError: true, strict: 'error' })
  return new nunjucks.runtime.SafeString(html)
}
const digits = new Intl.NumberFormat('en', { maximumSignificantDigits: 2 })
const round = number => number < 1000 ? digits.format(number) : Math.round(number).toLocaleString('en')
const size = bytes => bytes < 1e6 ? Math.max(1, Math.round(bytes / 1e3)) + ' kB' : (bytes / 1e6).toFixed(1) + ' MB'
templates.addFilter('math', math)
templates.addFilter('equation', latex => math(latex, true))
templates.addFilter('round', round)
templates.addFilter('of', (number, what) => `${round(number)} ${what}${number === 1 ? '' : 's'}`)

// The source of a page and the files of examples/ that it includes, itself first.
function sourcesOf(name) {
  const found = [], wanted = [`gallery/${name}.cpp`]
  for (const file of wanted) {
    const text = fs.readFileSync(path.join(sources, file), 'utf8')
    found.push({ file: `examples/${file}`, text, html: new nunjucks.runtime.SafeString(hljs.highlight(text, { language: 'cpp' }).value) })
    for (const [, included] of text.matchAll(/^#include <((?:models|motion|pictures|controllers)\/[^>]+)>/gm))
      if (!wanted.includes(included)) wanted.push(included)
  }
  return found
}

function compileSeconds(name) {
  const file = path.join(times, `${name}.cpp.seconds`)
  return fs.existsSync(file) ? Number(fs.readFileSync(file, 'utf8')) : null
}

function pageOf(name) {
  const folder = path.join(gallery, name)
  const page = JSON.parse(fs.readFileSync(path.join(folder, 'page.json'), 'utf8'))
  if (!chapters.some(each => each.title === page.kind))
    throw new Error(`${name}: there is no chapter ${page.kind} in chapters.json`)
  page.sources = sourcesOf(name)
  page.compile_seconds = compileSeconds(name)
  page.still = fs.existsSync(path.join(folder, 'still.jpg')) ? 'still.jpg' : 'figure.svg'
  for (const file of page.files) file.size = size(fs.statSync(path.join(folder, file.name)).size)
  return page
}

// KaTeX's style with its fonts inside, because browsers refuse fonts from other folders of a disk.
function katexStyle() {
  const folder = path.dirname(createRequire(import.meta.url).resolve('katex/dist/katex.min.css'))
  const css = fs.readFileSync(path.join(folder, 'katex.min.css'), 'utf8')
  return css.replace(/src:url\((fonts\/[^)]+\.woff2)\)[^;}]*/g, (_, font) =>
    `src:url(data:font/woff2;base64,${fs.readFileSync(path.join(folder, font)).toString('base64')}) format("woff2")`)
}

function write(file, text) {
  fs.mkdirSync(path.dirname(file), { recursive: true })
  fs.writeFileSync(file, text)
}

const names = fs.readdirSync(gallery).filter(each => fs.existsSync(path.join(gallery, each, 'page.json'))).sort()
const pages = names.map(pageOf).sort((a, b) => a.counts.multiplications - b.counts.multiplications) // from simple to large
for (const page of pages) write(path.join(gallery, page.name, 'index.html'), templates.render('page.html', { page }))
const listed = chapters.map(each => ({ ...each, pages: pages.filter(page => page.kind === each.title) })).filter(each => each.pages.length)
write(path.join(gallery, 'index.html'), templates.render('index.html', { chapters: listed, count: pages.length }))
write(path.join(gallery, 'assets', 'style.css'), fs.readFileSync(path.join(here, 'style.css')))
write(path.join(gallery, 'assets', 'katex.css'), katexStyle())
console.log(path.join(gallery, 'index.html'))
