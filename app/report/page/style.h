// The style sheet of the report: narrow screens first, light and dark; grades are shown by letter as well as by colour.
#pragma once

namespace touchstone::app {

inline constexpr const char* report_style = R"css(
:root{color-scheme:light dark;--ink:#1b2130;--soft:#586174;--paper:#f7f7f4;--card:#fff;--line:#dcdfe6;--link:#1d5a9e;
--a:#d5ecdc;--b:#e9f0bf;--c:#fde3a8;--d:#fac7a0;--f:#f4aeb0;--none:#edeff3;--heat:#d2641e;--one:#2563a8;--two:#b4531f;--wit:#a3145f}
@media(prefers-color-scheme:dark){:root{--ink:#e8eaf0;--soft:#a5adbc;--paper:#13161c;--card:#1b1f27;--line:#343a46;--link:#8fc1f5;
--a:#1e4a2f;--b:#424d18;--c:#614a10;--d:#6f3c15;--f:#7a2429;--none:#252a33;--heat:#c4581a;--one:#7db4f0;--two:#f0a36b;--wit:#f57ab8}}
*{box-sizing:border-box}
body{margin:0 auto;max-width:80rem;padding:1rem clamp(.8rem,3vw,2rem) 4rem;font:16px/1.5 system-ui,sans-serif;color:var(--ink);
background:var(--paper);overflow-wrap:anywhere}
h1{font-size:clamp(1.6rem,4vw,2.3rem);line-height:1.15;margin:.6rem 0 .3rem}
h2{font-size:1.3rem;margin:2.6rem 0 .6rem;border-bottom:1px solid var(--line);padding-bottom:.3rem}
h3{font-size:1rem;margin:0}p{margin:.4rem 0}a{color:var(--link)}.soft,small{color:var(--soft)}.lead{max-width:56rem}
nav{display:flex;flex-wrap:wrap;gap:.3rem 1.1rem;margin:.8rem 0}
.partial{border-left:.3rem solid var(--f);padding:.4rem .8rem;background:var(--card)}
.legend{display:grid;grid-template-columns:auto 1fr;gap:.2rem .6rem;font-size:.9rem;margin:.6rem 0}
.legend dd{font-size:.9rem}
[hidden]{display:none!important}
#filter{display:flex;flex-wrap:wrap;gap:.3rem 1.1rem;margin:.6rem 0;font-size:.9rem}
input{font:inherit;color:inherit;background:var(--card);border:1px solid var(--line);border-radius:.35rem;padding:.15rem .5rem;max-width:100%}
.scroll{overflow:auto;max-height:90vh;border:1px solid var(--line);border-radius:.6rem;background:var(--card)}
table{border-collapse:collapse;font-size:.84rem;font-variant-numeric:tabular-nums;width:100%}
th,td{padding:.26rem .6rem;text-align:left;border-bottom:1px solid var(--line);white-space:nowrap}
tbody tr:last-child>*{border-bottom:0}
thead th{background:var(--card);vertical-align:bottom;position:sticky;top:0;z-index:2;box-shadow:0 1px var(--line)}
thead th:first-child{left:0;z-index:3}
.by-subject th[scope=row]{white-space:normal;min-width:clamp(8rem,24vw,17rem)}.by-subject td{white-space:normal}.by-subject th small{display:block;font-weight:400}
.by-subject th[data-subject]{overflow-wrap:anywhere;white-space:normal;min-width:6.5rem}
section:target>h3{color:var(--link)}section,tr{scroll-margin-top:.5rem}
.matrix small{display:block;color:inherit}.matrix td a{text-decoration:none}.matrix td a:is(:hover,:focus-visible){text-decoration:underline}
.matrix thead th{white-space:normal}.matrix th,.matrix td{padding:.2rem .45rem}.matrix .g{margin-right:.2rem}.matrix td.none{background:none;text-align:center}
tbody th{font-weight:500;position:sticky;left:0;background:var(--card);z-index:1;border-right:1px solid var(--line)}
tr.query th,tr.query td{font-weight:700;background:var(--none)}td a{display:block;color:inherit}
.A,.A-{background:var(--a)}.A-{font-style:italic}.B{background:var(--b)}.C{background:var(--c)}.D{background:var(--d)}.F{background:var(--f)}
td.share{background:color-mix(in srgb,var(--link) calc(var(--share)*45%),transparent)}
td.none{background:var(--none);color:var(--soft)}
.g{color:var(--ink);display:inline-block;min-width:1.6em;text-align:center;font-weight:700;border-radius:.3rem;padding:0 .3rem;margin-right:.35rem}
.bar{display:flex;height:.7rem;border-radius:.35rem;overflow:hidden;margin:.5rem 0 .3rem;background:var(--none)}
.tally{display:flex;flex-wrap:wrap;gap:.1rem .7rem;font-size:.86rem;margin:.2rem 0 .5rem;padding:0;list-style:none}
.cards{display:grid;grid-template-columns:repeat(auto-fill,minmax(min(100%,21rem),1fr));gap:.9rem}
.card,details.row{background:var(--card);border:1px solid var(--line);border-radius:.6rem;padding:.9rem}
.card p{font-size:.9rem}.card ul{font-size:.86rem;padding-left:1.1rem;margin:.3rem 0}.card ul.tally{padding:0}
section>h3{margin:1.2rem 0 .4rem}section.card>h3{margin:0}details.row{margin:.45rem 0;padding:.15rem .9rem;scroll-margin-top:.5rem}details.row[open]{padding-bottom:.9rem}
details.row:target{border-color:var(--link)}
details.cause{margin:.45rem 0;padding:.15rem .9rem;border-left:.3rem solid var(--line)}
/* what is not on the screen is laid out when it comes there: the page of 59 subjects loads in two thirds of the time */
@media screen{.card,details.row,section>.scroll{content-visibility:auto;contain-intrinsic-size:auto 3rem}}
@media print{.scroll{overflow:visible;max-height:none}#filter,nav{display:none!important}thead th,tbody th{position:static}}
summary{cursor:pointer;padding:.35rem 0}summary b{margin-right:.5rem}
.drawn{display:grid;gap:.6rem 1.2rem}@media(min-width:56rem){.drawn{grid-template-columns:22rem 1fr}}
dl{display:grid;grid-template-columns:5.6rem 1fr;gap:.2rem .7rem;margin:.3rem 0 0;font-size:.88rem}dt{color:var(--soft)}dd{margin:0;min-width:0}
pre{white-space:pre-wrap;font-size:.84em}
code{font:.84em/1.4 ui-monospace,monospace;background:var(--none);padding:.08rem .3rem;border-radius:.25rem}
svg{display:block;width:100%;height:auto;max-width:26rem;margin:0 auto}
svg text{font-size:11px;fill:var(--soft)}svg:not(.plot) text{text-anchor:middle}svg text[class]{font-weight:700;font-size:12px;stroke:none}
svg path,svg circle,svg polygon{stroke-width:1.2;vector-effect:non-scaling-stroke;fill:none}
svg polygon{stroke:none}svg polygon,svg circle{fill-opacity:.13}
.body-0{stroke:var(--one)}polygon.body-0,circle.body-0,text.body-0{fill:var(--one)!important}
.body-1{stroke:var(--two);stroke-dasharray:5 2}polygon.body-1,circle.body-1,text.body-1{fill:var(--two)!important}
.body-2{stroke:var(--soft)}polygon.body-2,circle.body-2{fill:var(--soft)!important}
circle.ring{fill:none!important;stroke-dasharray:1.5 2}
path.exact{stroke:var(--wit);stroke-width:2}circle.exact{fill:var(--wit);fill-opacity:1;stroke:none}
path.claim{stroke:var(--ink);stroke-width:2;stroke-dasharray:4 3}circle.claim{stroke:var(--ink);stroke-width:1.5;fill:var(--card);fill-opacity:1}
path.before{stroke:var(--soft);stroke-width:2;stroke-dasharray:1 3}
figure{margin:0}figcaption{font-size:.8rem;text-align:center;color:var(--soft)}
figcaption .exact{color:var(--wit)}figcaption .claim{color:var(--ink)}
svg[tabindex]{cursor:grab;touch-action:pan-y}svg:focus-visible{outline:2px solid var(--link)}
table.atlas td,table.atlas th{white-space:nowrap;padding:.15rem .45rem}table.atlas small,table.atlas b{display:block}
table.atlas td:not(:empty){border-left:1px solid var(--card)}table.atlas b{font-size:.85em}table.left-out td:last-child{white-space:normal;min-width:18rem}
.h1{--h:14%}.h2{--h:22%}.h3{--h:29%}.h4{--h:36%}.h5{--h:43%}.h6{--h:50%}.h7{--h:57%}.h8{--h:64%}.h9{--h:72%}
td:is(.h1,.h2,.h3,.h4,.h5,.h6,.h7,.h8,.h9){background-color:color-mix(in srgb,var(--heat) var(--h),var(--card))}table.atlas td small{color:inherit}
td.out{background-image:repeating-linear-gradient(135deg,transparent 0 5px,color-mix(in srgb,var(--soft) 30%,transparent) 5px 6px)}
td.rim{outline:2px dashed var(--soft);outline-offset:-2px}
svg.plot{max-width:60rem;min-width:40rem;margin:0}svg.plot .grid{stroke:var(--line)}
svg.plot a{color:var(--soft)}svg.plot a text{fill:currentColor;text-anchor:start}svg.plot a.ours{color:var(--link)}svg.plot a.ours text{font-weight:700}
svg.plot a line{stroke:currentColor;stroke-width:2}svg.plot a .lead{stroke-width:.6;stroke-opacity:.55}
svg.plot circle{stroke:currentColor;stroke-width:2;fill-opacity:1}svg.plot .double{fill:currentColor}svg.plot .single{fill:var(--card)}
svg.plot a:is(:hover,:focus-visible){color:var(--two)}svg.plot a:is(:hover,:focus-visible) .lead{stroke-opacity:1;stroke-width:1.5}
)css";

}  // namespace touchstone::app
