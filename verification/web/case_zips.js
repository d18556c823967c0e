// node case_zips.js ROOT OUT < CHOICES: writes what the page offers for each choice of a JSON list: OUT/0.zip, OUT/1.zip, ..., and the template
// of the cutter table, OUT/template.csv. Prints the assumptions of each choice and the gages of `tables`, as JSON.

const fs = require("fs"), path = require("path"), vm = require("vm");
const [root, out] = process.argv.slice(2);

const page = ["case_text.js", "case_zip.js"].map(name => fs.readFileSync(path.join(root, "web/page", name), "utf8")).join("\n");
const {zipOf, zipFiles, templateCsv, assumptions, gageOf} = vm.runInNewContext(`${page}; ({zipOf, zipFiles, templateCsv, assumptions, gageOf})`, {TextEncoder});

const {choices, tables} = JSON.parse(fs.readFileSync(0, "utf8")), folder = path.join(root, "cases/bits");
const shipped = Object.fromEntries(fs.readdirSync(folder).filter(name => /^bit-[abcmr]\.(toml|csv)$/.test(name))
  .map(name => [name, fs.readFileSync(path.join(folder, name), "utf8")]));
const template = templateCsv(shipped["bit-b.csv"]);

fs.writeFileSync(path.join(out, "template.csv"), template);
choices.forEach((choice, k) => {
  if (choice.bit === "own" && !choice.table.text) choice.table.text = template;
  fs.writeFileSync(path.join(out, `${k}.zip`), zipOf(zipFiles(choice, shipped, "0.0, test")));
});
console.log(JSON.stringify({assumptions: choices.map(assumptions), gages: tables.map(gageOf)}));
