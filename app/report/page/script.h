// The script of the report: it opens what a link points to, and filters. Without it the page shows everything.
#pragma once

namespace touchstone::app {

inline constexpr const char* report_script = R"js(
const all = selector => [...document.querySelectorAll(selector)];

// A link into a closed <details> opens it, and all around it.
function reveal() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  for (let e = target; e; e = e.parentElement) if (e.tagName == 'DETAILS') e.open = true;
  if (target) target.scrollIntoView();
}

// Words in a field are alternatives: "bullet fcl" shows the subjects that contain either.
const filter = document.getElementById('filter');
const [subject, property] = filter.querySelectorAll('input');
const matches = (field, name) => {
  const words = field.value.toLowerCase().split(/[\s,]+/).filter(Boolean);
  return !words.length || words.some(word => name.toLowerCase().includes(word));
};

function show() {
  for (const e of all('[data-subject]')) e.toggleAttribute('hidden', !matches(subject, e.dataset.subject));
  for (const e of all('[data-property]')) e.hidden = !matches(property, e.dataset.property);
  for (const table of all('table.by-subject')) {
    const heads = [...table.tHead.rows[0].cells];
    for (const row of table.tBodies[0].rows) heads.forEach((head, i) => row.cells[i].hidden = head.hidden);
    const some = cells => cells.some(cell => !cell.hidden);
    table.closest('section').hidden = !some(heads.slice(1)) || !some([...table.tBodies[0].rows]);
  }
  for (const e of all('details.cause')) e.hidden = ![...e.querySelectorAll('.row')].some(row => !row.hidden);
}

function filtered() {
  show();
  const words = new URLSearchParams();
  for (const field of [subject, property]) if (field.value) words.set(field.name, field.value);
  try { history.replaceState(null, '', (`${words}` ? `?${words}` : location.pathname) + location.hash); } catch {}
}

filter.hidden = false;
for (const field of [subject, property]) field.value = new URLSearchParams(location.search).get(field.name) ?? '';
filter.addEventListener('input', filtered);
filter.addEventListener('submit', event => event.preventDefault());
addEventListener('hashchange', reveal);
show();
reveal();
)js";

}  // namespace touchstone::app
