// Colors and completions for the lines of a model.
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { completeFromList } from '@codemirror/autocomplete';
import { tags } from '@lezer/highlight';

const connecting = new Set(['on', 'from', 'about', 'by', 'along', 'at', 'in', 'to', 'and', 'mass', 'inertia',
  'stiffness', 'length', 'damping', 'rest']);

export function language({ words, functions }) {
  const known = new Set(words.map((each) => each.word)), callable = new Set(functions);
  const parser = {
    startState: () => ({ atStart: true }),
    token(stream, state) {
      if (stream.sol()) state.atStart = true;
      if (stream.eatSpace()) return null;
      if (stream.match(/^#.*/)) return 'comment';
      if (stream.match(/^(\d+\.?\d*|\.\d+)(e[-+]?\d+)?/i)) return 'number';
      const name = stream.match(/^[A-Za-z_]\w*/)?.[0];
      if (!name) return stream.next() && null;
      const isFirst = state.atStart;
      state.atStart = false;
      if (isFirst) return known.has(name) ? 'keyword' : 'invalid';
      if (stream.peek() === '(' && callable.has(name)) return 'function';
      if (stream.match(/^\.[xyz]\b/)) return 'className';
      return connecting.has(name) ? 'operatorKeyword' : 'variableName';
    },
    tokenTable: { function: tags.function(tags.variableName) },
    languageData: { commentTokens: { line: '#' } },
  };
  const style = HighlightStyle.define([
    { tag: tags.keyword, class: 'tok-word' },
    { tag: tags.operatorKeyword, class: 'tok-link' },
    { tag: tags.comment, class: 'tok-comment' },
    { tag: tags.number, class: 'tok-number' },
    { tag: tags.className, class: 'tok-axis' },
    { tag: tags.function(tags.variableName), class: 'tok-function' },
  ]);
  const atStart = completeFromList(words.map(({ word, pattern, meaning }) => (
    { label: word, detail: shown(pattern), info: meaning, type: 'keyword' })));
  const inside = completeFromList(functions.map((label) => ({ label, type: 'function' })));
  const complete = (context) => {
    const before = context.state.doc.lineAt(context.pos).text.slice(0, context.pos - context.state.doc.lineAt(context.pos).from);
    if (before.includes('#')) return null;
    return (/^\s*\w*$/.test(before) ? atStart : inside)(context);
  };
  return { extensions: [StreamLanguage.define(parser), syntaxHighlighting(style)], complete };
}

/// A pattern of the vocabulary for readers: <name> on <frame>.
export function shown(pattern) { return pattern.replaceAll('{', '‹').replaceAll('}', '›'); }
