// Converts equations to HTML: reads one JSON object {tex, display} from each line of standard input, and writes one JSON
// object {html} or {error} for each. docs/conf.py starts it once for the whole site.
const katex = require('/usr/share/nodejs/katex');
const lines = require('readline').createInterface({ input: process.stdin });
lines.on('line', (line) => {
  const equation = JSON.parse(line);
  let answer;
  try {
    answer = { html: katex.renderToString(equation.tex, { displayMode: equation.display, strict: 'error' }) };
  } catch (error) {
    answer = { error: String(error.message) };
  }
  process.stdout.write(JSON.stringify(answer) + '\n');
});
