// Ranks the results of the search: pages that explain come before pages about the project and its source tree.
var Scorer = {
  score: ([page, , , , score]) => {
    if (/^docs\/guide\//.test(page)) return score + 7
    if (/^docs\/tutorials\//.test(page)) return score + 5
    if (/^docs\/coming-from\//.test(page)) return score - 4
    return /^(docs\/|README)/.test(page) ? score : score - 8
  },
  objNameMatch: 11,
  objPartialMatch: 6,
  objPrio: { 0: 15, 1: 5, 2: -5 },
  objPrioDefault: 0,
  title: 15,
  partialTitle: 7,
  term: 5,
  partialTerm: 2,
}
