// How the report looks: narrow screens first, light and dark, grades told by letter as well as by colour.
#pragma once

namespace touchstone::app {

inline constexpr const char* report_style = R"css(
:root{--ink:#1c2230;--soft:#5b6475;--paper:#fbfbf9;--card:#fff;--line:#dcdfe6;--a:#dff1e4;--b:#eef4cf;--c:#fdebc0;--d:#fbd3b4;--f:#f6bdbd;
--none:#eceef2;--one:#2563a8;--two:#b4531f;--wit:#a3145f}
@media(prefers-color-scheme:dark){:root{--ink:#e8eaf0;--soft:#a3abba;--paper:#14171d;--card:#1c2028;--line:#343a46;--a:#1d4029;--b:#3c4518;
--c:#574310;--d:#613614;--f:#6b2323;--none:#262b34;--one:#7db4f0;--two:#f0a36b;--wit:#f57ab8}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:76rem;padding:1rem;font:16px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);overflow-wrap:anywhere}
h1{font-size:1.7rem;margin:.5rem 0 0}h2{font-size:1.25rem;margin:2.5rem 0 .5rem;border-bottom:1px solid var(--line);padding-bottom:.3rem}
h3{font-size:1rem;margin:0 0 .4rem}p{margin:.4rem 0}a{color:inherit}.soft{color:var(--soft)}small{color:var(--soft)}
nav{display:flex;flex-wrap:wrap;gap:.3rem 1rem;margin:.8rem 0}
.scroll{overflow-x:auto;border:1px solid var(--line);border-radius:.5rem;background:var(--card)}
table{border-collapse:collapse;font-size:.84rem;font-variant-numeric:tabular-nums}
th,td{padding:.28rem .55rem;text-align:left;border-bottom:1px solid var(--line);white-space:nowrap}
thead th{background:var(--card);vertical-align:bottom}tbody th{font-weight:500;position:sticky;left:0;background:var(--card);z-index:1}
tr.stem th{font-weight:700;background:var(--none)}td a{text-decoration:none;display:block}td a:hover,td a:focus{text-decoration:underline}
.A{background:var(--a)}.B{background:var(--b)}.C{background:var(--c)}.D{background:var(--d)}.F{background:var(--f)}.none{background:var(--none);color:var(--soft)}
.g{display:inline-block;min-width:1.5em;text-align:center;font-weight:700;border-radius:.25rem;padding:0 .25rem;margin-right:.25rem}
.cards{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,20rem),1fr));gap:.8rem}
.card,article{background:var(--card);border:1px solid var(--line);border-radius:.5rem;padding:.8rem}
details{margin:.5rem 0}summary{cursor:pointer;font-weight:600;padding:.3rem 0}
article{margin:.6rem 0;display:grid;gap:.3rem 1rem}@media(min-width:52rem){article.drawn{grid-template-columns:21rem 1fr}}
dl{display:grid;grid-template-columns:6.2rem 1fr;gap:.15rem .6rem;margin:0;font-size:.88rem}dt{color:var(--soft)}dd{margin:0}
code{font:.82rem/1.4 ui-monospace,monospace;background:var(--none);padding:.05rem .3rem;border-radius:.25rem}
svg{width:100%;height:auto;max-width:24rem}svg text{font-size:9px;fill:var(--soft);text-anchor:middle}
svg line,svg circle{fill:none;stroke-width:1.3;vector-effect:non-scaling-stroke}.body-0{stroke:var(--one)}.body-1{stroke:var(--two);stroke-dasharray:5 2}
.body-2{stroke:var(--soft)}line.witness{stroke:var(--wit);stroke-width:2}circle.witness{fill:var(--wit);stroke:none}
)css";

}  // namespace touchstone::app
