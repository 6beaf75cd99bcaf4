// Without a script the page is whole: nothing is hidden, and the budget is that at which it opens.
#include "accuracy/page/controls.h"

#include <cmath>

#include "report/svg.h"

namespace carom::tools::accuracy {
namespace {

using report::escape;

constexpr const char* kControlsStyle = R"(
#controls{position:sticky;top:0;z-index:5;background:var(--panel);border-bottom:1px solid var(--line);
border-radius:0 0 8px 8px;
padding:.6rem 1rem;display:flex;flex-wrap:wrap;gap:.4rem 1rem;align-items:center;font-size:.85rem}
#controls label{display:flex;gap:.35rem;align-items:center;color:var(--soft)}
#controls select,#controls input,#controls button{font:inherit;color:var(--ink);background:var(--ground);
border:1px solid var(--line);border-radius:5px;padding:.15rem .4rem}
#controls input[type=range]{padding:0;width:9rem}#controls input[type=search]{width:8rem}
#controls output{color:var(--ink);min-width:5.5rem;font-variant-numeric:tabular-nums}
.off{display:none}
#budget-table td:last-child{font-family:ui-monospace,monospace;font-size:.8rem}
svg:hover g.setting{opacity:.35}svg g.setting:hover{opacity:1}svg g.setting:hover polyline{stroke-width:2.4;
stroke-opacity:1}
.dot{cursor:crosshair}
@media print{nav,#tip,#controls{display:none}main{max-width:none;padding:0}h2{break-after:avoid}h3{break-after:avoid}
figure,tr{break-inside:avoid}details{display:none}body{font-size:11pt;background:#fff}a{color:inherit;
text-decoration:none}
tr.bad td:first-child::after{content:" !"}}
)";

// No character that mark-up would take for its own: so what is less is told by sign().
constexpr const char* kControlsScript = R"(
var tip=document.getElementById('tip');
document.addEventListener('mouseover',function(e){
var t=e.target.getAttribute?e.target.getAttribute('data-tip'):null;
if(!t){tip.style.opacity=0;return;}
tip.textContent=t.split('|').join('\n');tip.style.opacity=1;});
document.addEventListener('mousemove',function(e){
var right=Math.max(0,e.clientX+tip.offsetWidth+24-window.innerWidth);
tip.style.left=(right?e.clientX-tip.offsetWidth-14:e.clientX+14)+'px';tip.style.top=(e.clientY+14)+'px';});

function less(a,b){return Math.sign(b-a)===1;}
function get(id){return document.getElementById(id);}
function all(q,from){return Array.from((from?from:document).querySelectorAll(q));}
function number(x){return x===Infinity?'none':String(Number(x.toPrecision(2)));}
function frame(us){return less(us,100)?number(us)+' µs':number(us/1000)+' ms';}
function budget(){return Math.pow(10,get('my-budget').value/20);}

// What a filter asks for, of an element: its engine, the name of its setting, its scene.
function wanted(e){
var engine=get('by-engine').value,setting=get('by-setting').value,scene=get('by-scene').value.trim().toLowerCase();
var has=function(name){return e.hasAttribute(name);};
if(engine)if(has('data-engine'))if(e.getAttribute('data-engine')!==engine)return false;
if(setting)if(has('data-name')){var name=e.getAttribute('data-name'),preset=e.getAttribute('data-preset');
if(setting==='presets'?!preset:preset!==setting)if(setting!==name)return false;}
if(scene)if(has('data-scene'))if(e.getAttribute('data-scene').indexOf(scene)===-1)return false;
return true;}

// The least error within the budget; of equal ones the cheapest.
function best(scene){
var found=null;
all('.scene[data-scene="'+scene+'"] g.setting').forEach(function(g){
if(!wanted(g))return;
if(!get('by-engine').value)if(g.getAttribute('data-engine')!=='Carom')return;
all('.dot',g).forEach(function(dot){
var cost=1e6*dot.getAttribute('data-cost')/60,error=Math.max(1e-12,dot.getAttribute('data-error'));
if(less(budget(),cost))return;
if(found){if(less(found.error,error))return;if(found.error===error)if(!less(cost,found.cost))return;}
found={cost:cost,error:error,exact:Number(dot.getAttribute('data-error')),dt:dot.getAttribute('data-dt'),
engine:g.getAttribute('data-engine'),name:g.getAttribute('data-name'),dials:g.getAttribute('data-dials')};});});
return found;}

function fill(){
get('budget-text').textContent=frame(budget())+' a frame';
all('#budget-table tr[data-scene]').forEach(function(row){
var cells=all('td',row),scene=row.getAttribute('data-scene'),b=best(scene);
var step=b?'1/'+Number((1/b.dt).toPrecision(4)):'';
cells[1].textContent=b?(b.engine==='Carom'?'':b.engine+': ')+b.name+', '+step+' s':'nothing is as cheap';
cells[2].textContent=b?(number(b.exact)+' '+row.getAttribute('data-unit')).trim():'';
cells[3].textContent=b?frame(b.cost):'';
cells[4].textContent=b?(b.dials===null?'':'carom accuracy run '+scene+' '+b.dials+' --dt '+step):'';});}

function filter(){
all('[data-engine],[data-name],[data-scene]').forEach(function(e){e.classList.toggle('off',!wanted(e));});
fill();}

function sort(){
var red=get('by-order').value==='red';
all('.sorted').forEach(function(box){
var list=Array.from(box.children).filter(function(e){return e.hasAttribute('data-lead');});
var key=red?'data-lead':'data-place';
list.sort(function(a,b){return (red?1:-1)*(b.getAttribute(key)-a.getAttribute(key));});
list.forEach(function(e){box.appendChild(e);});});}

all('table').forEach(function(t){if(all('tr[data-lead]',t).length){all('tbody',t).forEach(function(b){b.classList.add('sorted');});}});
all('.sorted').forEach(function(box){Array.from(box.children).forEach(function(e,i){e.setAttribute('data-place',i);});
});
['by-engine','by-setting','by-scene'].forEach(function(id){get(id).addEventListener('input',filter);});
get('by-order').addEventListener('input',sort);
get('my-budget').addEventListener('input',fill);
get('look').addEventListener('input',function(){
get('dark').media={system:'screen and (prefers-color-scheme: dark)',light:'not all',dark:'screen'}[get('look').value];
});
get('print').addEventListener('click',function(){window.print();});
fill();
)";

std::string options(const std::vector<std::pair<std::string, std::string>>& list) {
  std::string text;
  for (const auto& [value, shown] : list)
    text += "<option value=\"" + escape(value) + "\">" + escape(shown) + "</option>";
  return text;
}

}  // namespace

std::string controls_markup(const std::vector<std::string>& engines, const std::vector<std::string>& settings,
                            const std::vector<std::string>& scenes) {
  std::vector<std::pair<std::string, std::string>> by_engine = {{"", "all"}};
  std::vector<std::pair<std::string, std::string>> by_setting = {{"", "all"}, {"presets", "presets"}};
  for (const std::string& engine : engines) by_engine.emplace_back(engine, engine);
  for (const std::string& setting : settings) by_setting.emplace_back(setting, setting);
  std::string names;
  for (const std::string& scene : scenes) names += "<option value=\"" + escape(scene) + "\"></option>";
  const int first = static_cast<int>(std::lround(20 * std::log10(1e6 * kFirstBudget)));
  return "<div id=\"controls\"><label>engine <select id=\"by-engine\">" + options(by_engine) +
         "</select></label><label>setting <select id=\"by-setting\">" + options(by_setting) +
         "</select></label><label>scene <input id=\"by-scene\" type=\"search\" list=\"scene-names\" "
         "placeholder=\"all\"/>"
         "<datalist id=\"scene-names\">" +
         names + "</datalist></label><label>order <select id=\"by-order\">" +
         options({{"", "of the suite"}, {"red", "red first"}}) +
         "</select></label><label>my budget <input id=\"my-budget\" type=\"range\" min=\"0\" max=\"80\" value=\"" +
         std::to_string(first) + "\"/><output id=\"budget-text\"></output></label><label>look <select id=\"look\">" +
         options({{"system", "as the system"}, {"light", "light"}, {"dark", "dark"}}) +
         "</select></label><button id=\"print\" type=\"button\">print</button></div>\n";
}

std::string controls_style() { return kControlsStyle; }
std::string controls_script() { return kControlsScript; }

}  // namespace carom::tools::accuracy
