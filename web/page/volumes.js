// What each cutter, or each row of teeth, has removed, as bars.

function sums(values, groups, count) {
  const total = new Array(count).fill(0);
  values.forEach((v, part) => { total[groups[part]] += v; });
  return total;
}

// Rows are made once; then only their numbers change.
function volumeBars(place, names) {
  const rows = names.map((name, k) => {
    const [row, label, bar, value] = ["tr", "th", "td", "td"].map(tag => document.createElement(tag)), fill = document.createElement("div");
    label.textContent = name;
    label.scope = "row";
    fill.className = "fill";
    bar.className = "bar-cell";
    bar.append(fill);
    row.append(label, bar, value);
    row.hidden = k === 0;
    return {row, fill, value};
  });
  place.replaceChildren(...rows.map(r => r.row));
  return totals => {
    const most = Math.max(...totals, 1e-30);
    rows.forEach(({row, fill, value}, k) => {
      row.hidden = totals[k] === 0;
      fill.style.width = `${(100 * totals[k] / most).toFixed(1)}%`;
      value.textContent = `${(1e6 * totals[k]).toFixed(3)} cm³`;
    });
  };
}
