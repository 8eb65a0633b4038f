// The text of the model, with the sentence of its mistake at the line where it was made.
import { autocompletion, closeBrackets, completionKeymap } from '@codemirror/autocomplete';
import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { lintGutter, setDiagnostics } from '@codemirror/lint';
import { EditorState } from '@codemirror/state';
import { EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers }
  from '@codemirror/view';
import { language } from './language.js';

export function openEditor(parent, vocabulary, onChange) {
  const { extensions, complete } = language(vocabulary);
  const view = new EditorView({
    parent,
    state: EditorState.create({
      extensions: [
        lineNumbers(), highlightActiveLineGutter(), history(), drawSelection(), highlightActiveLine(),
        closeBrackets(), autocompletion({ override: [complete], icons: false }), lintGutter(), extensions,
        keymap.of([...completionKeymap, ...defaultKeymap, ...historyKeymap, indentWithTab]),
        EditorView.lineWrapping,
        EditorView.contentAttributes.of({ 'aria-label': 'Model', spellcheck: 'false', autocapitalize: 'off' }),
        EditorView.updateListener.of((update) => { if (update.docChanged) onChange(); }),
      ],
    }),
  });
  return {
    get text() { return view.state.doc.toString(); },
    set text(text) { view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: text } }); },
    /// Inserts a line below those that it may need: at the end of the text.
    add(line) {
      const text = view.state.doc.toString();
      const insert = (text === '' || text.endsWith('\n') ? '' : '\n') + line + '\n';
      view.dispatch({ changes: { from: text.length, insert }, scrollIntoView: true,
        selection: { anchor: text.length + insert.length - 1 } });
    },
    show(mistake) {
      const marks = [];
      if (mistake && mistake.line > 0 && mistake.line <= view.state.doc.lines) {
        const { from, to } = view.state.doc.line(mistake.line);
        marks.push({ from, to, severity: 'error', message: mistake.sentence });
      }
      view.dispatch(setDiagnostics(view.state, marks));
    },
  };
}
