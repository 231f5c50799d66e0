// src/later/actions.ts
import {
  addMeter as sl,
  adding as ul,
  aim as cl,
  ask as pl,
  back as ml,
  candles as fn,
  chosenLamps as se,
  clearSolo as dl,
  command as vn,
  compareHeld as hl,
  copyAlong as bl,
  copyText as gl,
  deselect as fl,
  each as Et,
  edit as Vt,
  exposeBy as yn,
  falseColor as vl,
  fine as kn,
  forth as yl,
  frameSelection as kl,
  go as wl,
  goHome as xl,
  goInside as Ml,
  goPreset as Cl,
  handles as wn,
  hands as Sl,
  here as $l,
  highlight as Ll,
  history as xn,
  lampMarks as Mn,
  lamps as Qe,
  listing as Cn,
  lookOnly as Sn,
  panels as $n,
  PRESETS as Tl,
  register as Pl,
  removeLamps as El,
  say as Ze,
  scene as Vl,
  selection as An,
  send as Al,
  sheet as Ne,
  show as ql,
  soloSelection as Il,
  spot as De,
  startTool as xe,
  stepSelection as Ln,
  storeLook as Rl,
  storeView as Fl,
  theme as Tn,
  things as Pn,
  titleOf as qn,
  toggleFalse as Hl,
  toggleWipe as Nl,
  travel as En,
  views as Dl,
  walking as Pt,
  whyNot as Z
} from "./desk.js";
var ie = () => Z() ?? (se.value.length ? null : "Select a lamp first.");
function Ol() {
  let e = se.peek(), t = !e.some((n) => Qe.get(n)?.on);
  Vt(`${qn(e)} ${t ? "on" : "off"}`, { lamps: Et(e, { on: t }) });
}
function Wl() {
  let e = se.peek(), t = !e.every((n) => Qe.get(n)?.parked);
  Vt(`${t ? "Park" : "Unpark"} ${qn(e)}`, { lamps: Et(e, { parked: t }) });
}
function Vn(e) {
  let t = An.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : Pn.ids.peek().filter((a) => Pn.get(a)?.hidden);
  if (!n.length) return Ze(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Vt(e ? "Hide things" : "Show hidden things", { things: Et(n, { hidden: e }) });
}
function Gl() {
  let e = se.peek()[0], t = Qe.get(e)?.place, n = $l();
  if (!t?.position || !t.direction || !n) return Ze("Select a lamp that has a direction.", "warn");
  let { position: a, direction: l } = t;
  wl({ ...n, eye: a, target: [a[0] + l[0], a[1] + l[1], a[2] + l[2]], height: null, near: null }, "from the lamp");
}
function Bl() {
  pl("command", {}, (e) => {
    gl(e.text);
  });
}
var Kl = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Ul = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, zl = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: kl },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: xl },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: Ml },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: ml },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: yl },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Fl, why: Z },
  ...Tl.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Ul[e],
    keys: `Shift+${t + 1}`,
    run: () => Cl(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      Pt.value = Pt.peek() === "walk" ? "fly" : "walk", Ze(Pt.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: Gl, why: ie },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => Ln(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => Ln(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => xe("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => An.value = { kind: "lamp", ids: Qe.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: fl },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: Ol, why: ie },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Il, why: () => se.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: dl },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => Ll(!0), why: ie },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Wl, why: ie },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => xe("aim"), why: ie },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => De.peek() && cl(se.peek(), De.peek().point), why: ie },
  { id: "move", group: "Lamps", label: "Handles to move", keys: "G", run: () => wn.value = "move" },
  { id: "turn", group: "Lamps", label: "Handles to turn", keys: "R", run: () => wn.value = "turn" },
  ...Kl.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: Z,
    run: () => {
      ul.value = e, xe("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => bl(se.peek(), 1, [0.5, 0, 0]), why: ie },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => El(se.peek()), why: ie },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => Vn(!0), why: Z },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => Vn(!1), why: Z },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => vn({ do: "undo" }), why: () => Z() ?? (xn.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => vn({ do: "redo" }), why: () => Z() ?? (xn.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => Ne.value = "save", why: Z },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => Ne.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Bl },
  { id: "share", group: "Work", label: "Share by link", run: () => Ne.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: Hl },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = vl();
      ql({ false_color: { ...e, quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => yn(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => yn(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => Al({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => hl(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: Nl },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: Z, run: () => De.peek() ? sl(De.peek().point, De.peek().normal) : xe("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => xe("meter"), why: Z },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => xe("grid"), why: Z },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => fn.value = fn.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Rl, why: Z },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => Ze("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => $n.value = !$n.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => Cn.value = Cn.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => En.value = En.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => Mn.value = !Mn.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => kn.value = !kn.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => Tn.value = Tn.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => Sn.value = !Sn.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => Sl.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => Ne.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => Ne.value = "palette" }
];
Pl(zl);
function Je() {
  return [...(Vl.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...Dl.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as _l, comparing as Xl, digits as Yl, fitted as jl, useEffect as Zl, useRef as Ql, viewSize as Jl, wipeAt as At } from "./desk.js";
import { Fragment as to, jsx as qt, jsxs as no } from "./desk.js";
function eo() {
  let e = Xl.value, t = _l.value, n = Ql(null);
  if (Zl(() => {
    let s = n.current;
    !s || !t || (s.width = t.picture.width, s.height = t.picture.height, s.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = Jl.value, l = At.value, r = jl(t.picture.width, t.picture.height), o = Math.max(0, Math.min(1, (l * a - r.x) / (t.picture.width * r.scale))), i = (s) => {
    let p = s.currentTarget;
    if (s.stopPropagation(), s.type === "pointerdown") p.setPointerCapture(s.pointerId);
    else if (p.hasPointerCapture(s.pointerId)) {
      let c = p.parentElement.getBoundingClientRect();
      At.value = Math.max(0, Math.min(1, (s.clientX - c.left) / c.width));
    }
  }, u = (s) => {
    let p = { ArrowLeft: -0.02, ArrowRight: 0.02 }[s.key];
    p && (s.stopPropagation(), s.preventDefault(), At.value = Math.max(0, Math.min(1, l + p)));
  };
  return no(to, { children: [
    qt(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * o}% 0 0)` : "none" }
      }
    ),
    qt("span", { class: "tag left", children: "before" }),
    e === "wipe" && qt(
      "div",
      {
        class: "wipe",
        "data-handle": "wipe",
        role: "slider",
        tabIndex: 0,
        "aria-label": "Wipe between before and now",
        "aria-valuemin": 0,
        "aria-valuemax": 100,
        "aria-valuenow": Math.round(l * 100),
        "aria-valuetext": `${Yl(l * 100)} % before`,
        style: { left: `${100 * l}%` },
        onPointerDown: i,
        onPointerMove: i,
        onKeyDown: u
      }
    )
  ] });
}

// src/later/handles.tsx
import {
  chosenLamps as Wn,
  computed as Gn,
  editor as mo,
  effect as ho,
  fitted as bo,
  Gesture as go,
  handles as fo,
  lamps as nt,
  lookOnly as vo,
  pinhole as yo,
  placed as ko,
  positionOf as Dn,
  positions as wo,
  role as xo,
  selection as On,
  shown as Mo,
  titleOf as Co,
  tool as So,
  useEffect as $o,
  useRef as Lo,
  viewSize as To
} from "./desk.js";

// src/later/gizmo.ts
import { project as In, ray as ao } from "./desk.js";
import { across as lo, add as ee, cross as oo, distance as ro, dot as ue, length as io, normal as et, scale as te, sub as Me, turn as so } from "./desk.js";
var uo = "http://www.w3.org/2000/svg", It = 84, ge = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], tt = ["x", "y", "z"], Rn = 0.1, co = 5 * Math.PI / 180, Fn = 48;
function Nn(e, t) {
  let n = (d, b, f) => {
    let k = document.createElementNS(uo, d);
    return k.setAttribute("class", f), b.append(k), k;
  }, a = (d, b, f) => {
    let k = n("g", e, `handle ${d} ${tt[b] ?? ""}`);
    return k.setAttribute("data-handle", f), { group: k, hit: n("path", k, "hit"), seen: n("path", k, "seen") };
  }, l = n("path", e, "aim-line"), r = ge.map((d, b) => a("ring", b, `ring-${tt[b]}`)), o = ge.map((d, b) => a("plane", b, `plane-${tt[b]}`)), i = ge.map((d, b) => a("arrow", b, `move-${tt[b]}`)), u = a("centre", -1, "move-view"), s = a("aim", -1, "aim"), p = n("text", e, "handle-text"), c = (d, b) => {
    let [f, k, L] = In(d.hole, b);
    return L < 0.02 && !d.hole.parallel ? null : [d.fit.x + f * d.fit.scale, d.fit.y + k * d.fit.scale];
  }, g = (d, b) => {
    let f = In(d.hole, b)[2];
    return It / d.fit.scale * d.hole.pixel * (d.hole.parallel ? 1 : Math.max(f, 0.02));
  }, m = (d, b, f = !1) => {
    let k = b.filter((C) => C !== null), L = k.length < b.length || k.length < 2 ? "" : `M${k.map((C) => `${C[0].toFixed(1)} ${C[1].toFixed(1)}`).join("L")}${f ? "Z" : ""}`;
    d.setAttribute("d", L);
  }, v = (d, b, f) => {
    d.setAttribute("d", b ? `M${b[0] - f} ${b[1]}a${f} ${f} 0 1 0 ${2 * f} 0a${f} ${f} 0 1 0 ${-2 * f} 0` : "");
  }, y = (d, b) => d.forEach((f) => f.group.classList.toggle("gone", !b));
  function R(d, b) {
    let f = d.position, k = c(b, f), L = g(b, f), C = d.mode === "move";
    y([...i, ...o, u], C && k !== null), y(r, !C && k !== null && d.direction !== null);
    let z = d.aim ?? (d.direction ? ee(f, te(d.direction, 3 * L)) : null);
    if (y([s], z !== null && k !== null), !k) {
      l.setAttribute("d", "");
      return;
    }
    ge.forEach((K, N) => {
      let I = c(b, ee(f, te(K, L))), he = I ? Math.hypot(I[0] - k[0], I[1] - k[1]) < 12 : !0;
      if (i[N].group.classList.toggle("gone", !C || he), I && C) {
        let [be, Fe] = [(I[0] - k[0]) / It, (I[1] - k[1]) / It], je = Math.hypot(be, Fe) || 1, [re, He] = [be / je, Fe / je], Tt = [k[0] + 14 * re, k[1] + 14 * He];
        m(i[N].hit, [Tt, I]), i[N].seen.setAttribute("d", `M${Tt[0].toFixed(1)} ${Tt[1].toFixed(1)}L${I[0].toFixed(1)} ${I[1].toFixed(1)}M${(I[0] - 9 * re - 4.5 * He).toFixed(1)} ${(I[1] - 9 * He + 4.5 * re).toFixed(1)}L${I[0].toFixed(1)} ${I[1].toFixed(1)}L${(I[0] - 9 * re + 4.5 * He).toFixed(1)} ${(I[1] - 9 * He - 4.5 * re).toFixed(1)}`);
      }
      let [Ie, Re] = [ge[(N + 1) % 3], ge[(N + 2) % 3]], j = Math.abs(ue(K, b.hole.parallel ? b.hole.forward : et(Me(f, b.hole.eye)))) < 0.15;
      o[N].group.classList.toggle("gone", !C || j);
      let Ye = (be, Fe) => c(b, ee(f, ee(te(Ie, be * L), te(Re, Fe * L)))), gn = [Ye(0.3, 0.3), Ye(0.5, 0.3), Ye(0.5, 0.5), Ye(0.3, 0.5)];
      if (m(o[N].hit, gn, !0), m(o[N].seen, gn, !0), !C) {
        let be = Array.from({ length: Fn + 1 }, (Fe, je) => {
          let re = 2 * Math.PI * je / Fn;
          return c(b, ee(f, ee(te(Ie, Math.cos(re) * L), te(Re, Math.sin(re) * L))));
        });
        m(r[N].hit, be), m(r[N].seen, be);
      }
    }), v(u.hit, k, 13), v(u.seen, k, 7);
    let q = z && c(b, z);
    m(l, [k, q]), v(s.hit, q, 16), s.seen.setAttribute("d", q ? `M${q[0] - 8} ${q[1]}h16M${q[0]} ${q[1] - 8}v16M${q[0] - 5} ${q[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let B = t.effect(() => {
    let d = t.target.value, b = t.view.value;
    e.classList.toggle("empty", !d || !b), d && b && R(d, b);
  }), dn = (d, b, f) => ao(d.hole, (b.clientX - f.left - d.fit.x) / d.fit.scale, (b.clientY - f.top - d.fit.y) / d.fit.scale);
  function qe(d, b, f) {
    d.addEventListener("pointerdown", (k) => {
      if (k.button !== 0) return;
      k.preventDefault(), k.stopPropagation();
      let L = t.view.peek();
      if (!L || !t.target.peek()) return;
      let C = e.getBoundingClientRect(), z = f(L), q = t.hold(b), K = dn(L, k, C);
      z(K, !1, { ...q, move: () => {
      }, turn: () => {
      } }), d.setPointerCapture(k.pointerId), d.classList.add("held");
      let N = (j) => {
        p.textContent = z(dn(L, j, C), j.ctrlKey || j.metaKey, q), p.setAttribute("x", String(j.clientX - C.left + 16)), p.setAttribute("y", String(j.clientY - C.top - 12));
      }, I = (j) => {
        d.removeEventListener("pointermove", N), d.removeEventListener("pointerup", he), d.removeEventListener("pointercancel", Ie), removeEventListener("keydown", Re, !0), d.classList.remove("held"), p.textContent = "", j ? q.end() : q.cancel();
      }, he = () => I(!0), Ie = () => I(!1), Re = (j) => {
        j.key === "Escape" && (j.stopPropagation(), I(!1));
      };
      d.addEventListener("pointermove", N), d.addEventListener("pointerup", he), d.addEventListener("pointercancel", Ie), addEventListener("keydown", Re, !0);
    });
  }
  let $t = (d, b, f) => f ? Math.round(d / b) * b : d, Lt = (d) => d.map((b) => b.toFixed(2)).join("  ") + " m";
  ge.forEach((d, b) => {
    qe(i[b].group, "move", () => {
      let f = t.target.peek().position, k = null;
      return (L, C, z) => {
        let q = po(f, d, L);
        k ??= q;
        let K = te(d, $t(q - k, Rn, C));
        return z.move(K), Lt(K);
      };
    }), qe(o[b].group, "move", () => hn(d)), qe(r[b].group, "turn", () => {
      let f = t.target.peek(), k = f.direction, L = { at: null };
      return (C, z, q) => {
        let K = Hn(f.position, d, C), N = K && et(Me(K, f.position), lo(d));
        if (!N) return "";
        L.at ??= N;
        let I = Math.atan2(ue(d, oo(L.at, N)), ue(L.at, N)), he = $t(I, co, z);
        return q.turn(et(so(k, d, he)), null), `${(he * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), qe(u.group, "move", (d) => hn(d.hole.forward)), qe(s.group, "aim", (d) => {
    let b = t.target.peek(), f = b.aim ?? ee(b.position, te(b.direction, 3 * g(d, b.position))), k = bn(f, d.hole.forward);
    return (L, C, z) => {
      let q = k(L, C), K = ee(f, q);
      return ro(K, b.position) > 1e-3 && z.turn(et(Me(K, b.position)), K), Lt(K);
    };
  });
  function hn(d) {
    let b = bn(t.target.peek().position, d);
    return (f, k, L) => {
      let C = b(f, k);
      return L.move(C), Lt(C);
    };
  }
  function bn(d, b) {
    let f = null;
    return (k, L) => {
      let C = Hn(d, b, k);
      return C ? (f ??= C, Me(C, f).map((z) => $t(z, Rn, L))) : [0, 0, 0];
    };
  }
  return { stop: B };
}
function po(e, t, n) {
  let a = Me(e, n.origin), l = ue(t, n.direction), r = 1 - l * l;
  return r < 1e-6 ? 0 : (l * ue(n.direction, a) - ue(t, a)) / r;
}
function Hn(e, t, n) {
  let a = ue(t, n.direction);
  if (Math.abs(a) < 1e-4 * io(t)) return null;
  let l = ue(Me(e, n.origin), t) / a;
  return l < 0 || l > 1e3 ? null : ee(n.origin, te(n.direction, l));
}

// src/later/handles.tsx
import { jsx as Io } from "./desk.js";
var Po = Gn(() => {
  if (On.value?.kind !== "lamp" && On.value?.kind !== "group" || vo.value || xo.value === "watch" || !mo.value.you || So.value === "aim") return null;
  let e = Wn.value.filter((n) => Dn(nt.get(n)));
  if (!e.length) return null;
  let t = nt.get(e[e.length - 1]);
  return {
    position: Dn(t),
    direction: t.place?.direction ?? null,
    aim: t.place?.aim ?? null,
    mode: fo.value
  };
}), Eo = Gn(() => {
  let e = Mo.value;
  if (To.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: yo(e.camera, t, n), fit: bo(t, n) };
}), Vo = () => Wn.peek().filter((e) => nt.entry(e)), Ao = {
  effect: ho,
  target: Po,
  view: Eo,
  hold(e) {
    let t = Vo(), n = e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn", a = new go(`${n} ${Co(t)}`), l = wo(t);
    return {
      move: (r) => a.set(ko(t, r, l)),
      turn: (r, o) => {
        let i = Object.fromEntries(
          t.filter((u) => nt.entry(u)?.shown.peek().place?.direction).map((u) => [u, { place: { direction: r, aim: o } }])
        );
        a.set({ lamps: i });
      },
      end: () => a.end(),
      cancel: () => a.cancel()
    };
  }
};
function qo() {
  let e = Lo(null);
  return $o(() => Nn(e.current, Ao).stop, []), Io("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/inspector.tsx
import { act as qa, deselect as Dr, Icon as Jt, selection as Or, signal as Wr } from "./desk.js";

// src/later/measure.tsx
import {
  deselect as Un,
  digits as fe,
  edit as lt,
  grids as Do,
  Icon as zn,
  length as $e,
  luxText as Oe,
  maintenance as Rt,
  meters as Oo,
  selection as _n,
  spacing as Wo
} from "./desk.js";

// src/later/parts.tsx
import { Field as Bn, Gesture as Ro, Range as Fo, stroke as Ho, useRef as No } from "./desk.js";
import { jsx as ne, jsxs as at } from "./desk.js";
function V({ title: e, note: t, children: n }) {
  return at("section", { class: "part", "aria-label": e, children: [
    at("h3", { children: [
      e,
      t && ne("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function W(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function A(e) {
  return at("label", { class: "line", children: [
    ne("span", { children: e.label }),
    ne(Bn, { ...e })
  ] });
}
function Q({ label: e, names: t, quantity: n, value: a, set: l, step: r, disabled: o }) {
  let i = t ?? ["X", "Y", "Z"];
  return at("div", { class: "line", role: "group", "aria-label": e, children: [
    ne("span", { children: e }),
    ne("span", { class: "triple", children: i.map((u, s) => ne(
      Bn,
      {
        label: `${e} ${u}`,
        quantity: n,
        value: a[s],
        text: a[s] === null ? void 0 : n === "length" ? a[s].toFixed(2) : void 0,
        step: r,
        disabled: o,
        set: (p) => l(s, p)
      },
      u
    )) })
  ] });
}
function Ce({ label: e, name: t, value: n, text: a, patch: l, reset: r, notch: o, class: i, style: u, disabled: s }) {
  let p = No(null), c = (m) => () => {
    p.current?.[m](), p.current = null;
  }, g = (m) => p.current ? p.current.set(l(m)) : Ho(e + t, t, l(m));
  return ne(
    Fo,
    {
      label: e,
      value: n,
      text: a,
      notch: o,
      class: i,
      gradient: u,
      disabled: s,
      begin: () => p.current = new Ro(t),
      on: g,
      end: c("end"),
      cancel: c("cancel"),
      reset: r === void 0 ? void 0 : () => g(r)
    }
  );
}
function Se({ value: e, label: t, set: n }) {
  return ne("span", { class: "field name-field", children: ne(
    "input",
    {
      type: "text",
      "aria-label": t,
      value: e,
      maxLength: 120,
      spellcheck: !1,
      onChange: (a) => {
        let l = a.currentTarget.value.trim();
        l && l !== e ? n(l) : a.currentTarget.value = e;
      },
      onKeyDown: (a) => {
        a.key === "Enter" && a.currentTarget.blur(), a.key === "Escape" && (a.stopPropagation(), a.currentTarget.value = e, a.currentTarget.blur());
      }
    }
  ) });
}
var ae = (e, t, n) => e.map((a, l) => l === t ? n(a) : a);

// src/later/measure.tsx
import { Fragment as Ft, jsx as T, jsxs as U } from "./desk.js";
var Go = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["camera", "toward the camera"]];
function Xn() {
  let e = _n.value?.ids[0], t = Oo.get(e);
  if (!t) return T("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, l) => {
    let { lux: r, ...o } = { ...t, ...l };
    lt(`${t.name}: ${a}`, { meters: { [e]: o } });
  };
  return U(Ft, { children: [
    T("header", { class: "panel-head", children: T(Se, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    T("p", { class: "crumbs", children: t.lux ? `${Oe(t.lux[0] * Rt.value)} ±${Oe(t.lux[1] * Rt.value, !1)}` : "measuring" }),
    T("div", { class: "scroll", children: U(V, { title: "Meter", children: [
      U("label", { class: "line", children: [
        T("span", { children: "Measures" }),
        T("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: Go.map(([a, l]) => T("option", { value: a, children: l }, a)) })
      ] }),
      T(Q, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, l) => n("move", { point: ae(t.point, a, l) }) }),
      T(Q, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, l) => n("turn", { normal: ae(t.normal, a, l) }) }),
      U("button", { class: "plain full", onClick: () => {
        Un(), lt(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        T(zn, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var Kn = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function Yn() {
  let e = _n.value?.ids[0], t = Do.get(e);
  if (!t) return T("p", { class: "quiet empty", children: "This grid is gone." });
  let n = Rt.value, a = (i, u) => {
    let { name: s, corner: p, u: c, v: g, normal: m, columns: v, rows: y, target: R } = { ...t, ...u };
    lt(`${t.name}: ${i}`, { grids: { [e]: { name: s, corner: p, u: c, v: g, normal: m, columns: v, rows: y, target: R } } });
  }, l = () => {
    let i = Wo(Math.max($e(t.u), $e(t.v)));
    a("standard spacing", { columns: Math.max(1, Math.ceil($e(t.u) / i)), rows: Math.max(1, Math.ceil($e(t.v) / i)) });
  }, r = (i, u, s) => U(Ft, { children: [
    T("dt", { children: i }),
    T("dd", { children: u === null ? "…" : s(u) })
  ] }), o = t.target ?? { lux: 500, uniformity: 0.6 };
  return U(Ft, { children: [
    T("header", { class: "panel-head", children: T(Se, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    U("p", { class: "crumbs", children: [
      fe($e(t.u), 2),
      " × ",
      fe($e(t.v), 2),
      " m, ",
      fe(t.columns * t.rows),
      " points"
    ] }),
    U("div", { class: "scroll", children: [
      T(V, { title: "Figures", note: n === 1 ? "new" : `× ${fe(n, 2)}`, children: U("dl", { class: "figures", children: [
        r("Ē", t.mean, (i) => Oe(i * n)),
        r("E min", t.min, (i) => Oe(i * n)),
        r("E max", t.max, (i) => Oe(i * n)),
        r("U₀ = min / mean", t.uniformity, (i) => fe(i, 2)),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => fe(i, 2)),
        r("±", t.error, (i) => `${fe(i * 100, 1)} %`)
      ] }) }),
      U(V, { title: "Target", children: [
        U("label", { class: "line", children: [
          T("span", { children: "Class" }),
          U("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let u = Kn[Number(i.currentTarget.value)];
            a("target", { target: u ? { lux: u[1], uniformity: u[2] } : null });
          }, children: [
            T("option", { value: "", children: t.target ? "choose…" : "none" }),
            Kn.map(([i, u, s], p) => U("option", { value: p, children: [
              i,
              ": ",
              u,
              " lx, U₀ ",
              s
            ] }, i)),
            T("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        T(A, { label: "Ē at least", quantity: "lux", step: 50, value: o.lux, set: (i) => a("target", { target: { ...o, lux: i(o.lux) } }) }),
        T(A, { label: "U₀ at least", quantity: "share", step: 0.05, value: o.uniformity, set: (i) => a("target", { target: { ...o, uniformity: i(o.uniformity) } }) })
      ] }),
      U(V, { title: "Area", children: [
        T(Q, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, u) => a("move", { corner: ae(t.corner, i, u) }) }),
        T(A, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        T(A, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        T("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: l, children: "Spacing of the standard" }),
        U("button", { class: "plain full", onClick: () => {
          Un(), lt(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          T(zn, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as ye,
  chosenLamps as nr,
  copyAlong as ar,
  digits as lr,
  dot as Wt,
  edit as it,
  format as ra,
  groups as st,
  handles as ot,
  Icon as Te,
  lamps as Ut,
  layers as or,
  normal as ia,
  output as sa,
  percent as Kt,
  placed as rr,
  positionOf as ea,
  positions as ir,
  selection as Gt,
  signal as ua,
  spot as sr,
  sub as ta,
  titleOf as zt,
  tool as ur,
  toLevel as na,
  toTravel as cr,
  typeLevel as Bt,
  up as pr,
  Fade as mr,
  Field as dr,
  wantLevel as aa,
  compass as ca,
  add as ut,
  scale as Pe,
  length as hr,
  Range as br,
  strokeLevel as la,
  useRef as gr
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as zo,
  digits as Zn,
  edit as _o,
  fromHex as Xo,
  hex as Yo,
  lamps as Qn,
  mired as ve,
  titleOf as jo
} from "./desk.js";

// src/later/white.ts
import { css as Bo, mired as Ht } from "./desk.js";
function Ko(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((r) => Math.max(0, r));
}
function Uo(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function jn(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (l, r) => {
    let o = Ht(e) + (Ht(t) - Ht(e)) * r / (n - 1);
    return Bo(Ko(...Uo(1e6 / o)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as Dt, jsx as D, jsxs as ce } from "./desk.js";
var We = 1800, Ot = 1e4, Zo = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], Qo = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], Jo = jn(We, Ot), Nt = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(Qn.get(n).color) }]))
}), er = (e) => {
  let t = 1e6 / (ve(We) + (ve(Ot) - ve(We)) * e);
  return Math.round(t / 10) * 10;
}, tr = (e) => (ve(e) - ve(We)) / (ve(Ot) - ve(We));
function Jn() {
  let e = zo.value, t = e.map((o) => Qn.get(o)?.color).filter((o) => o !== void 0);
  if (!t.length) return null;
  let n = W(t.map((o) => o.mode)), a = t[0], l = jo(e), r = (o, i) => _o(`${l}: ${o}`, Nt(e, i));
  return ce(Dt, { children: [
    ce("div", { class: "line", children: [
      D("span", { children: "Colour" }),
      D("div", { class: "segments", role: "group", "aria-label": "Colour by", children: Qo.map(([o, i]) => D("button", { "aria-pressed": n === o, onClick: () => r(`colour by ${i}`, () => ({ mode: o })), children: i }, o)) })
    ] }),
    n === "kelvin" && ce(Dt, { children: [
      ce("div", { class: "line slide", children: [
        D("span", { children: "White" }),
        D(
          Ce,
          {
            label: "Colour temperature",
            name: `${l}: white`,
            class: "mired",
            style: Jo,
            value: tr(a.kelvin),
            text: `${Zn(a.kelvin)} kelvin`,
            patch: (o) => Nt(e, () => ({ mode: "kelvin", kelvin: er(o) }))
          }
        )
      ] }),
      D(
        A,
        {
          label: "",
          quantity: "kelvin",
          value: W(t.map((o) => o.kelvin)),
          step: 50,
          set: (o) => r("white", (i) => ({ mode: "kelvin", kelvin: o(i.kelvin) }))
        }
      ),
      D("div", { class: "whites", role: "group", "aria-label": "Whites", children: Zo.map(([o, i]) => D("button", { title: i, "aria-label": `${o} kelvin, ${i}`, onClick: () => r(`${o} K`, () => ({ mode: "kelvin", kelvin: o })), children: o }, o)) }),
      ce("div", { class: "line slide", children: [
        D("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        D(
          Ce,
          {
            label: "Tint, magenta to green",
            name: `${l}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${Zn(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (o) => Nt(e, () => ({ tint: Math.round((o * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      D(A, { label: "", quantity: "number", value: W(t.map((o) => o.tint)), step: 1, set: (o) => r("tint", (i) => ({ tint: Math.max(-50, Math.min(50, o(i.tint))) })) })
    ] }),
    n === "rgb" && ce(Dt, { children: [
      ce("label", { class: "line", children: [
        D("span", { children: "Colour" }),
        D("input", { type: "color", class: "pick", "aria-label": "Colour", value: Yo(a.rgb), onChange: (o) => r("colour", () => ({ mode: "rgb", rgb: Xo(o.currentTarget.value) })) })
      ] }),
      D(
        Q,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (o, i) => r("colour", (u) => ({ rgb: u.rgb.map((s, p) => p === o ? Math.max(0, i(s)) : s) }))
        }
      )
    ] }),
    n === "xy" && ce("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      D("span", { children: "x, y" }),
      D("span", { class: "triple", children: [0, 1].map((o) => D(
        A,
        {
          label: "xy"[o],
          quantity: "number",
          step: 1e-3,
          value: W(t.map((i) => i.xy[o])),
          set: (i) => r("chromaticity", (u) => ({ xy: u.xy.map((s, p) => p === o ? Math.max(0.01, Math.min(0.9, i(s))) : s) }))
        },
        o
      )) })
    ] }),
    n === null && D("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as _t, jsx as w, jsxs as F } from "./desk.js";
var Le = ua(1), rt = ua([1, 0, 0]), ct = 180 / Math.PI;
function oa(e, t) {
  let { right: n, ahead: a } = ca(t), l = -Wt(e, t);
  return [Math.atan2(Wt(e, n), Wt(e, a)) * ct, Math.asin(Math.max(-1, Math.min(1, l))) * ct];
}
function fr(e, t, n) {
  let { right: a, ahead: l } = ca(n), [r, o] = [e / ct, t / ct], i = ut(Pe(a, Math.sin(r)), Pe(l, Math.cos(r)));
  return ia(ut(Pe(i, Math.cos(o)), Pe(n, -Math.sin(o))));
}
function vr({ ids: e, all: t }) {
  let n = t.some((a) => a.place?.direction);
  return F("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    F("button", { "aria-pressed": ur.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => ye("aim"), children: [
      w(Te, { name: "aim" }),
      "Aim"
    ] }),
    w("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => ye("solo"), children: w(Te, { name: "solo" }) }),
    w("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => ye("from-lamp"), children: w(Te, { name: "eye" }) }),
    w("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => ye("frame"), children: w(Te, { name: "frame" }) }),
    w("span", { class: "gap" }),
    w("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((a) => a.parked), onClick: () => ye("park"), children: "Park" }),
    w("button", { class: "icon", "aria-label": `Remove ${zt(e)}`, title: "Remove (Del)", onClick: () => ye("remove"), children: w(Te, { name: "bin" }) })
  ] });
}
function yr({ ids: e, all: t }) {
  let n = W(t.map((o) => o.level)), a = t.reduce((o, i) => o + i.flux * sa(i), 0), l = t.every((o) => o.free), r = e[e.length - 1];
  return F(V, { title: "Light", note: l ? "re-mix" : "re-trace", children: [
    F("div", { class: "line slide", children: [
      w("span", { children: "Level" }),
      w(kr, { id: r })
    ] }),
    F("label", { class: "line", children: [
      w("span", {}),
      w(
        dr,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: W(t.map((o) => o.flux)) ?? void 0,
          step: 0.01,
          set: (o) => Bt(e, o),
          open: aa.value,
          opened: () => aa.value = "",
          id: "level"
        }
      )
    ] }),
    w(
      A,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (o) => Bt(e, (i, u) => o(i * u) / u)
      }
    ),
    w("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: [-1, -1 / 3, 1 / 3, 1].map((o) => F("button", { onClick: () => Bt(e, (i) => Math.min(1e3, i * 2 ** o)), children: [
      o < 0 ? "−" : "+",
      Math.abs(o) === 1 ? "1" : "⅓",
      " stop"
    ] }, o)) }),
    F("p", { class: "sum", children: [
      ra(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (st.get(t[0].group)?.level ?? 1) !== 1 && ` (${Kt(t[0].level)} % × ${Kt(st.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    w(Jn, {})
  ] });
}
function kr({ id: e }) {
  let t = gr(null), n = Ut.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, l = (r) => () => {
    t.current?.[r](), t.current = null;
  };
  return w(
    br,
    {
      label: "Level",
      value: cr(n.level),
      text: `${Kt(n.level)} %, ${ra(n.flux * sa(n), "flux")}`,
      begin: () => t.current = new mr(a),
      on: (r) => t.current ? t.current.to(na(r)) : la(a, na(r)),
      end: l("end"),
      cancel: l("cancel"),
      reset: () => la(a, 1)
    }
  );
}
function Ge(e, t, n) {
  let a = {};
  for (let l of e) {
    let r = Ut.get(l), o = n(r.place ?? {}, r);
    o && (a[l] = { place: o });
  }
  Object.keys(a).length && it(`${zt(e)}: ${t}`, { lamps: a });
}
function wr({ ids: e, all: t }) {
  let n = (l) => W(t.map((r) => r.place?.[l] ?? null)), a = (l) => t.some((r) => r.place?.[l] != null);
  return !a("outer") && !a("radius") ? null : F(V, { title: "Beam", note: "re-trace", children: [
    a("outer") && F(_t, { children: [
      w(A, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (l) => Ge(e, "beam", (r) => r.outer == null ? null : { inner: Math.max(0.1, Math.min(r.outer, l(r.inner ?? r.outer))) }) }),
      w(A, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (l) => Ge(e, "beam", (r) => {
        if (r.outer == null) return null;
        let o = Math.max(0.2, Math.min(179, l(r.outer)));
        return { outer: o, inner: Math.min(r.inner ?? o, o) };
      }) })
    ] }),
    a("radius") && w(A, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (l) => Ge(e, "radius", (r) => r.radius == null ? null : { radius: Math.max(1e-3, l(r.radius)) }) })
  ] });
}
function xr({ ids: e, all: t }) {
  let n = t.filter((c) => ea(c) !== null);
  if (!n.length) return null;
  let a = n.map((c) => ea(c)), l = (c, g) => W(g.map((m) => Math.round(m[c] * 1e4) / 1e4)), r = t.filter((c) => c.place?.direction), o = pr.value, i = r.map((c) => oa(c.place?.direction, o).map((g) => Math.round(g * 10) / 10)), u = t.map((c) => c.place?.aim).filter((c) => !!c), s = (c, g) => {
    let m = ir(e), v = {};
    for (let [y, R] of m) {
      let B = [0, 0, 0];
      B[c] = g(R[c]) - R[c], Object.assign(v, rr([y], B, m).lamps);
    }
    it(`Move ${zt(e)}`, { lamps: v });
  }, p = (c, g) => Ge(e, c ? "tilt" : "pan", (m) => {
    if (!m.direction) return null;
    let v = oa(m.direction, o);
    v[c] = g(v[c]);
    let y = fr(v[0], Math.max(-90, Math.min(90, v[1])), o), R = m.aim && m.position ? hr(ta(m.aim, m.position)) : 0;
    return { direction: y, ...R && m.position ? { aim: ut(m.position, Pe(y, R)) } : {} };
  });
  return F(V, { title: "Place", note: "re-trace", children: [
    w(Q, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => l(c, a)), set: s }),
    r.length > 0 && F(_t, { children: [
      w(A, { label: "Pan", quantity: "angle", step: 1, value: W(i.map((c) => c[0])), set: (c) => p(0, c) }),
      w(A, { label: "Tilt", quantity: "angle", step: 1, value: W(i.map((c) => c[1])), set: (c) => p(1, c) }),
      w(
        Q,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: u.length ? [0, 1, 2].map((c) => l(c, u)) : [null, null, null],
          set: (c, g) => Ge(e, "aim", (m) => {
            if (!m.direction || !m.position) return null;
            let v = ae(m.aim ?? ut(m.position, Pe(m.direction, 2)), c, g);
            return { aim: v, direction: ia(ta(v, m.position)) };
          })
        }
      )
    ] }),
    F("div", { class: "line", children: [
      w("span", { children: "Handles" }),
      F("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        w("button", { "aria-pressed": ot.value === "move", onClick: () => ot.value = "move", children: "Move" }),
        w("button", { "aria-pressed": ot.value === "turn", onClick: () => ot.value = "turn", children: "Turn" })
      ] })
    ] }),
    r.length > 0 && sr.value && w("button", { class: "plain full", onClick: () => ye("aim-here"), children: "Aim at the last point" })
  ] });
}
function Mr({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : F(V, { title: "Copies along a line", children: [
    w(A, { label: "How many", quantity: "number", step: 1, value: Le.value, set: (n) => Le.value = Math.max(1, Math.min(100, Math.round(n(Le.value)))) }),
    w(Q, { label: "Step", quantity: "length", step: 0.05, value: rt.value, set: (n, a) => rt.value = ae(rt.value, n, a) }),
    F("button", { class: "plain full", onClick: () => ar(e, Le.value, rt.value), children: [
      w(Te, { name: "copy" }),
      Le.value === 1 ? "One copy" : `${Le.value} copies`
    ] })
  ] });
}
function pa() {
  let e = nr.value, t = e.map((o) => Ut.get(o)).filter((o) => !!o);
  if (!t.length) return w("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && st.get(n.group), l = Gt.value?.kind === "group" ? st.get(Gt.value.ids[0]) : void 0, r = n?.layer != null ? or.value[n.layer] : void 0;
  return F(_t, { children: [
    w("header", { class: "panel-head", children: n ? w(Se, { label: "Name of the lamp", value: n.name, set: (o) => it(`Rename ${n.name}`, { lamps: { [e[0]]: { name: o } } }) }) : l ? w(Se, { label: "Name of the group", value: l.name, set: (o) => it(`Rename ${l.name}`, { groups: { [Gt.value.ids[0]]: { name: o } } }) }) : F("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    F("p", { class: "crumbs", children: [
      n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((o) => o.on).length} of ${t.length} on`,
      n?.layer != null && ` · layer ${lr(n.layer + 1)}`
    ] }),
    F("div", { class: "scroll", children: [
      w(vr, { ids: e, all: t }),
      w(yr, { ids: e, all: t }),
      w(V, { title: "Photometry", children: w("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      w(wr, { ids: e, all: t }),
      w(xr, { ids: e, all: t }),
      w(Mr, { ids: e, all: t }),
      w("p", { class: "cost", children: t.every((o) => o.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as Xt,
  candles as pt,
  command as Cr,
  digits as dt,
  edit as ma,
  Field as Sr,
  filterOf as ga,
  go as $r,
  history as Lr,
  hovered as da,
  Icon as ht,
  layers as Tr,
  lookOnly as ha,
  maintenance as Ee,
  materials as Pr,
  percent as Er,
  scene as Vr,
  select as fa,
  signal as Ar,
  singleKeys as ba,
  sub as qr,
  things as Ir,
  travel as mt,
  Virtual as va
} from "./desk.js";
import { Fragment as Rr, jsx as x, jsxs as E } from "./desk.js";
function ya() {
  let e = Vr.value;
  if (!e) return null;
  let t = qr(e.bounds[1], e.bounds[0]);
  return E(Rr, { children: [
    E(V, { title: "Room", children: [
      E("p", { children: [
        t.map((n) => dt(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${dt(e.triangles)} triangles` : ""
      ] }),
      x("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && x("ul", { class: "buttons", children: e.cameras.map((n, a) => x("li", { children: x("button", { onClick: () => $r(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && E("details", { children: [
        E("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        x("ul", { class: "remarks", children: e.warnings.map((n) => x("li", { children: n }, n)) })
      ] })
    ] }),
    E(V, { title: "Figures", children: [
      E("label", { class: "line", children: [
        x("span", { children: "Maintenance" }),
        x(Sr, { label: "Maintenance factor", quantity: "share", value: Ee.value, step: 0.05, set: (n) => Ee.value = Math.max(0.1, Math.min(1, n(Ee.value))) })
      ] }),
      E("p", { class: "quiet", children: [
        Ee.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Ee.value === 1 && x("button", { class: "plain", onClick: () => Ee.value = 0.8, children: "0.80" })
      ] }),
      E("div", { class: "line", children: [
        x("span", { children: "Unit" }),
        E("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          x("button", { "aria-pressed": pt.value === "lx", onClick: () => pt.value = "lx", children: "lx, cd/m²" }),
          x("button", { "aria-pressed": pt.value === "fc", onClick: () => pt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    x(V, { title: "Layers of light", children: x("ul", { class: "layers", children: Tr.value.map((n, a) => E("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      x("i", { class: "dot", "aria-hidden": "true" }),
      x("span", { children: n.name || `layer ${a + 1}` }),
      x("small", { children: n.held ? "held" : Er(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    E(V, { title: "Hands", children: [
      E("div", { class: "line", children: [
        x("span", { children: "Faders" }),
        E("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          x("button", { "aria-pressed": mt.value === "square", onClick: () => mt.value = "square", children: "Square law" }),
          x("button", { "aria-pressed": mt.value === "linear", onClick: () => mt.value = "linear", children: "Even" })
        ] })
      ] }),
      E("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: ba.value, onChange: (n) => ba.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      E("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: ha.value, onChange: (n) => ha.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var bt = Ar("");
function ka({ label: e }) {
  return x("span", { class: "field filter", children: x("input", { type: "text", "aria-label": e, placeholder: "Filter", value: bt.value, onInput: (t) => bt.value = t.currentTarget.value }) });
}
function wa() {
  let e = ga(Ir, bt.value);
  return E("div", { class: "listing", children: [
    x(ka, { label: "Filter things" }),
    x(
      va,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => da.value = { kind: "thing", id: n }, onPointerLeave: () => da.value = null, children: [
            x("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => ma(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: x(ht, { name: a.hidden ? "eye-off" : "eye" }) }),
            x("button", { class: "row-name", onClick: () => fa("thing", n), children: x("span", { children: a.name }) }),
            x("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => ma(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: x(ht, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function xa() {
  let e = ga(Pr, bt.value);
  return E("div", { class: "listing", children: [
    x(ka, { label: "Filter materials" }),
    x(
      va,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return E("div", { class: "sheet-row material", role: "listitem", children: [
            x("button", { class: "row-name", onClick: () => fa("material", n), children: x("span", { children: a.name }) }),
            E("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${dt(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function Ma() {
  let e = Lr.value;
  return E(V, { title: "History", children: [
    E("p", { children: [
      e.steps === 1 ? "One step" : `${dt(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => Xt("undo"), children: [
      x(ht, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    E("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => Xt("redo"), children: [
      x(ht, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    x("button", { class: "plain full", onClick: () => Xt("save"), children: "Save a version with a name…" }),
    x("button", { class: "plain full", onClick: () => Cr({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as Yt,
  edit as La,
  fromHex as Fr,
  hex as Hr,
  Icon as Ca,
  materials as Ta,
  middle as Sa,
  select as Pa,
  selection as Ea,
  things as jt
} from "./desk.js";
import { Fragment as Qt, jsx as S, jsxs as _ } from "./desk.js";
var Zt = 180 / Math.PI;
function $a(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * Zt : 0;
}
function Nr(e, t) {
  let n = [0, 0, 0, Math.cos(t / Zt / 2)];
  return n[e] = Math.sin(t / Zt / 2), n;
}
function Va() {
  let e = (Ea.value?.ids ?? []).filter((u) => jt.get(u)), t = e.map((u) => jt.get(u));
  if (!t.length) return S("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, l = t.some((u) => u.locked), r = (u, s) => La(`${a}: ${u}`, { things: Object.fromEntries(e.map((p, c) => [p, s(t[c])])) }), o = t.map((u) => u.place?.position ?? (u.box ? Sa(u.box) : [0, 0, 0])), i = n.box ? [0, 1, 2].map((u) => n.box[1][u] - n.box[0][u]) : null;
  return _(Qt, { children: [
    S("header", { class: "panel-head", children: S("h2", { children: a }) }),
    i && _("p", { class: "crumbs", children: [
      i.map((u) => Yt(u, 2)).join(" × "),
      " m"
    ] }),
    _("div", { class: "scroll", children: [
      _("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        _("button", { "aria-pressed": t.every((u) => u.hidden), onClick: () => r(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          S(Ca, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        _("button", { "aria-pressed": l, onClick: () => r(l ? "unlock" : "lock", () => ({ locked: !l })), children: [
          S(Ca, { name: l ? "lock" : "unlock" }),
          l ? "Locked" : "Lock"
        ] })
      ] }),
      _(V, { title: "Place", note: "re-trace", children: [
        l && S("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        S(
          Q,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: l,
            value: [0, 1, 2].map((u) => W(o.map((s) => Math.round(s[u] * 1e4) / 1e4))),
            set: (u, s) => r("move", (p) => ({ place: { position: ae(p.place?.position ?? Sa(p.box), u, s) } }))
          }
        ),
        [0, 1, 2].map((u) => S(
          A,
          {
            label: `Turn ${"XYZ"[u]}`,
            quantity: "angle",
            step: 5,
            disabled: l,
            value: W(t.map((s) => Math.round($a(s.place?.rotation, u) * 10) / 10)),
            set: (s) => r("turn", (p) => ({ place: { rotation: Nr(u, s($a(p.place?.rotation, u))) } }))
          },
          u
        )),
        S(
          A,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: l,
            value: W(t.map((u) => u.place?.scale ?? 1)),
            set: (u) => r("scale", (s) => ({ place: { scale: Math.max(1e-3, u(s.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      S(V, { title: "Materials", children: S("ul", { class: "buttons", children: n.materials.map((u) => S("li", { children: S("button", { onClick: () => Pa("material", u), children: Ta.get(u)?.name ?? `material ${u}` }) }, u)) }) })
    ] })
  ] });
}
function Aa() {
  let e = Ea.value?.ids[0], t = Ta.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This material is gone." });
  let n = (s, p) => La(`${t.name}: ${s}`, { materials: { [e]: p } }), a = t.transmittance ? "transmittance" : "color", l = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], o = ((s) => 0.2126 * s[0] + 0.7152 * s[1] + 0.0722 * s[2])(l), i = (s) => l.map((p) => Math.max(0, Math.min(1, o > 1e-4 ? p / o * s : s))), u = (s, p) => t[p] != null && _(Qt, { children: [
    _("div", { class: "line slide", children: [
      S("span", { children: s }),
      S(Ce, { label: s, name: `${t.name}: ${s.toLowerCase()}`, value: t[p], text: Yt(t[p], 2), patch: (c) => ({ materials: { [e]: { [p]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    S(A, { label: "", quantity: "share", step: 0.01, value: t[p], set: (c) => n(s.toLowerCase(), { [p]: Math.max(0, Math.min(1, c(t[p]))) }) })
  ] });
  return _(Qt, { children: [
    S("header", { class: "panel-head", children: S("h2", { children: t.name }) }),
    S("p", { class: "crumbs", children: t.kind }),
    _("div", { class: "scroll", children: [
      _(V, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        _("div", { class: "line slide", children: [
          S("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          S(Ce, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: o, text: Yt(o, 2), patch: (s) => ({ materials: { [e]: { [a]: i(Math.min(0.95, s)) } } }) })
        ] }),
        S(A, { label: "", quantity: "share", step: 0.01, value: Math.round(o * 1e3) / 1e3, set: (s) => n("reflectance", { [a]: i(Math.min(0.98, s(o))) }) }),
        _("label", { class: "line", children: [
          S("span", { children: "Colour" }),
          S("input", { type: "color", class: "pick", "aria-label": "Colour", value: Hr(l), onChange: (s) => n("colour", { [a]: Fr(s.currentTarget.value) }) })
        ] }),
        u("Roughness", "roughness"),
        u("Gloss", "specular")
      ] }),
      S(V, { title: "On", children: S("ul", { class: "buttons", children: jt.all().filter(([, s]) => s.materials.includes(e)).slice(0, 40).map(([s, p]) => S("li", { children: S("button", { onClick: () => Pa("thing", s), children: p.name }) }, s)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as Ia, jsx as O, jsxs as en } from "./desk.js";
var Be = ["Scene", "Things", "Materials", "History"], pe = Wr("Scene");
function Gr() {
  let e = { Scene: ya, Things: wa, Materials: xa, History: Ma }[pe.value];
  return en(Ia, { children: [
    O("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), pe.value = Be[(Be.indexOf(pe.value) + a + Be.length) % Be.length], document.getElementById(`tab-${pe.value}`)?.focus());
    }, children: Be.map((n) => O("button", { id: `tab-${n}`, role: "tab", "aria-selected": pe.value === n, "aria-controls": "tab-panel", tabIndex: pe.value === n ? 0 : -1, onClick: () => pe.value = n, children: n }, n)) }),
    O("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${pe.value}`, tabIndex: 0, children: O(e, {}) })
  ] });
}
function Br() {
  let e = Or.value;
  return e ? en(Ia, { children: [
    en("nav", { class: "chooser", "aria-label": "Selection", children: [
      O("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => qa("previous"), children: O(Jt, { name: "back" }) }),
      O("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => qa("next"), children: O(Jt, { name: "forth" }) }),
      O("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      O("span", { class: "gap" }),
      O("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: Dr, children: O(Jt, { name: "close" }) })
    ] }),
    (e.kind === "lamp" || e.kind === "group") && O(pa, {}),
    e.kind === "thing" && O(Va, {}),
    e.kind === "material" && O(Aa, {}),
    e.kind === "meter" && O(Xn, {}),
    e.kind === "grid" && O(Yn, {})
  ] }) : O(Gr, {});
}

// src/later/legend.tsx
import { candles as Kr, display as Ur, Field as zr, show as _r, three as Ra, useRef as Xr } from "./desk.js";
import { jsx as X, jsxs as gt } from "./desk.js";
var tn = [1, 2, 5];
function Yr(e, t, n) {
  let a = [];
  if (n === "linear") {
    let l = (t - e) / 5, r = 10 ** Math.floor(Math.log10(l)), o = r * (tn.find((i) => i * r >= l) ?? 10);
    for (let i = Math.ceil(e / o) * o; i <= t * 1.0001; i += o) a.push(i);
    return a;
  }
  for (let l = Math.floor(Math.log10(e)); l <= Math.ceil(Math.log10(t)); l++)
    for (let r of tn) {
      let o = r * 10 ** l;
      o >= e * 0.999 && o <= t * 1.001 && a.push(o);
    }
  return a.length > 10 ? a.filter((l) => Math.abs(Math.log10(l) % 1) < 1e-6) : a;
}
function jr(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var le = (e, t) => {
  let n = { ...e, ...t };
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && _r({ false_color: n });
};
function Fa(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return tn[a] * 10 ** ((n - a) / 3);
}
function Zr() {
  let e = Ur.value.false_color, t = Xr(null);
  if (!e) return null;
  let n = Kr.value === "fc", a = e.quantity === "illuminance", l = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", r = n ? a ? 1 / 10.7639 : 0.2919 : 1, o = e.colors, i = o?.length ? `linear-gradient(to top, ${o.join(", ")})` : void 0, u = (p) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: p, from: e[p] };
    },
    onPointerMove: (c) => {
      let g = t.current;
      g?.end === p && le(e, { [p]: Fa(g.from, Math.round((g.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let g = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      g && (c.preventDefault(), c.stopPropagation(), le(e, { [p]: Fa(e[p], g) }));
    }
  }), s = ({ end: p }) => gt("div", { class: "end", children: [
    X(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": p === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[p],
        "aria-valuemin": 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${Ra(e[p] * r)} ${l}`,
        ...u(p)
      }
    ),
    X(
      zr,
      {
        label: p === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[p] * r).toPrecision(3)),
        set: (c) => le(e, { [p]: c(e[p] * r) / r })
      }
    )
  ] });
  return gt("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    gt("header", { children: [
      X(
        "button",
        {
          "aria-label": `Quantity: ${a ? "illuminance" : "luminance"}`,
          onClick: () => le(e, { quantity: a ? "luminance" : "illuminance" }),
          children: l
        }
      ),
      X("button", { "aria-pressed": e.scale === "log", onClick: () => le(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      X("button", { "aria-pressed": e.lines, onClick: () => le(e, { lines: !e.lines }), children: "lines" })
    ] }),
    X(s, { end: "high" }),
    X("div", { class: "scale", style: { background: i }, children: Yr(e.low, e.high, e.scale).map((p) => X("span", { style: { bottom: `${100 * jr(p, e)}%` }, children: Ra(p * r) }, p)) }),
    X(s, { end: "low" }),
    gt("footer", { children: [
      X("button", { onClick: () => le(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      X("button", { onClick: () => le(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      X(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (p) => le(e, { palette: p.currentTarget.value }),
          children: e.palettes?.map((p) => X("option", { children: p }, p)) ?? X("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as ln,
  act as Ua,
  ask as ii,
  command as si,
  copyText as ui,
  digits as ci,
  go as pi,
  hear as mi,
  lamps as di,
  say as on,
  select as hi,
  send as vt,
  sheet as Ue,
  shown as bi,
  signal as ze,
  useEffect as kt,
  useRef as wt,
  walkNames as gi,
  whyNotTo as fi
} from "./desk.js";

// src/later/csv.ts
import { add as Ha, grids as Qr, maintenance as Jr, meters as ei, scale as Na, scene as Da } from "./desk.js";
var ti = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function ni() {
  let e = Jr.peek(), t = [["scene", Da.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of ei.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of Qr.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [l, r] of Object.entries(a)) t.push([l, r === null ? null : r * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), n.lux.forEach((l, r) => {
      let [o, i] = [r % n.columns, Math.floor(r / n.columns)], u = Ha(n.corner, Ha(Na(n.u, (o + 0.5) / n.columns), Na(n.v, (i + 0.5) / n.rows)));
      t.push([...u.map((s) => s.toFixed(3)), l === null ? null : l * e]);
    });
  }
  return t.map((n) => n.map(ti).join(",")).join(`\r
`) + `\r
`;
}
function nn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function Oa() {
  let e = URL.createObjectURL(new Blob([ni()], { type: "text/csv" }));
  nn(`${Da.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var Ba = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], ft = new Uint8Array(512), an = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  ft[e] = ft[e + 255] = t, an[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var Wa = (e, t) => e && t ? ft[an[e] + an[t]] : 0;
function ai(e, t) {
  let n = [1];
  for (let l = 0; l < t; l++) {
    let r = new Array(n.length + 1).fill(0);
    n.forEach((o, i) => {
      r[i] ^= o, r[i + 1] ^= Wa(o, ft[l]);
    }), n = r;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let l = 0; l < e.length; l++) {
    let r = a[l];
    r && n.forEach((o, i) => a[l + i] ^= Wa(o, r));
  }
  return a.slice(e.length);
}
function li(e, t) {
  let [n, a, l] = Ba[t - 1], r = [], o = (g, m) => {
    for (let v = m - 1; v >= 0; v--) r.push(g >> v & 1);
  };
  for (o(4, 4), o(e.length, 8), e.forEach((g) => o(g, 8)), o(0, Math.min(4, n * 8 - r.length)); r.length % 8; ) r.push(0);
  let i = [];
  for (let g = 0; g < r.length; g += 8) i.push(parseInt(r.slice(g, g + 8).join(""), 2));
  for (let g = 236; i.length < n; g ^= 253) i.push(g);
  let u = n / l, s = Array.from({ length: l }, (g, m) => i.slice(m * u, (m + 1) * u)), p = s.map((g) => ai(g, a)), c = (g) => g[0].flatMap((m, v) => g.map((y) => y[v]));
  return [...c(s), ...c(p)];
}
var oi = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function ri(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function Ga(e) {
  let t = e.length, n = 0, a = 0;
  for (let l of [!1, !0])
    for (let r = 0; r < t; r++) {
      let o = Array.from({ length: t }, (s, p) => l ? e[p][r] : e[r][p]), i = 1;
      for (let s = 1; s <= t; s++)
        s < t && o[s] === o[s - 1] ? i++ : (i >= 5 && (n += i - 2), i = 1);
      let u = o.map(Number).join("");
      for (let s = 0; s + 11 <= t; s++) {
        let p = u.slice(s, s + 11);
        (p === "10111010000" || p === "00001011101") && (n += 40);
      }
    }
  for (let l = 0; l < t; l++)
    for (let r = 0; r < t; r++)
      e[l][r] && a++, r && l && e[l][r] === e[l - 1][r] && e[l][r] === e[l][r - 1] && e[l][r] === e[l - 1][r - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function Ka(e) {
  let t = [...new TextEncoder().encode(e)], n = Ba.findIndex(([m]) => t.length + 2 <= m) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, l = Array.from({ length: a }, () => new Array(a).fill(!1)), r = Array.from({ length: a }, () => new Array(a).fill(!1)), o = (m, v, y) => {
    m < 0 || v < 0 || m >= a || v >= a || (l[v][m] = y, r[v][m] = !0);
  };
  for (let m = 0; m < a; m++)
    o(m, 6, m % 2 === 0), o(6, m, m % 2 === 0);
  for (let [m, v] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let y = -4; y <= 4; y++)
      for (let R = -4; R <= 4; R++) {
        let B = Math.max(Math.abs(R), Math.abs(y));
        o(m + R, v + y, B !== 2 && B !== 4);
      }
  if (n > 1) {
    let m = a - 7;
    for (let v = -2; v <= 2; v++) for (let y = -2; y <= 2; y++) o(m + y, m + v, Math.max(Math.abs(y), Math.abs(v)) !== 1);
  }
  let i = (m) => {
    let v = ri(m);
    for (let y = 0; y < 15; y++) {
      let R = (v >> y & 1) === 1, B = y < 6 ? y : y < 8 ? y + 1 : a - 15 + y;
      o(8, B, R), o(y < 8 ? a - 1 - y : y < 9 ? 7 : 14 - y, 8, R);
    }
    o(8, a - 8, !0);
  };
  i(0);
  let u = li(t, n), s = 0;
  for (let m = a - 1; m > 0; m -= 2) {
    m === 6 && (m = 5);
    for (let v = 0; v < a; v++)
      for (let y of [m, m - 1]) {
        let B = (m + 1 & 2) === 0 ? a - 1 - v : v;
        r[B][y] || (l[B][y] = s < u.length * 8 && (u[s >> 3] >> 7 - (s & 7) & 1) === 1, s++);
      }
  }
  let p = (m) => (i(m), l.map((v, y) => v.map((R, B) => R !== (!r[y][B] && oi[m](B, y))))), c = p(0), g = Ga(c);
  for (let m = 1; m < 8; m++) {
    let v = p(m), y = Ga(v);
    y < g && ([c, g] = [v, y]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as Li, jsx as h, jsxs as $ } from "./desk.js";
function _e({ title: e, wide: t, children: n }) {
  let a = wt(null);
  kt(() => {
    let r = a.current, o = document.activeElement;
    return r.open || r.showModal(), () => o?.focus();
  }, []);
  let l = () => Ue.value = null;
  return h(
    "dialog",
    {
      ref: a,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: l,
      onClick: (r) => r.target === a.current && l(),
      children: $("div", { class: "sheet-body", children: [
        $("header", { children: [
          h("h2", { children: e }),
          h("span", { class: "gap" }),
          h("button", { onClick: l, children: "Close" })
        ] }),
        n
      ] })
    }
  );
}
var vi = [
  ["Look around", "right or left drag", "arrows", "one finger"],
  ["Walk, up and down", "", "walking keys, Q E; Shift fast, Alt slow", "pad at the left"],
  ["Orbit about a point", "middle or Alt+left drag", "Shift+arrows", ""],
  ["Pan", "Shift+middle, Space+left drag", "Ctrl+arrows", "two fingers"],
  ["Nearer, farther", "wheel; Shift goes through", "+ −", "pinch"],
  ["Select; add; toggle", "click; Shift; Ctrl", "Tab in the list, [ ]", "tap"],
  ["Deeper: group, thing behind", "click again", "", "tap again"],
  ["Lux under the pointer", "hover", "P lays a meter", ""],
  ["What lights this", "right click", "Shift+P", "long press"],
  ["Level", "fader, wheel on it; Shift is fine", "digits Enter; arrows, Shift 10 %", "fader, two at once"],
  ["Default level", "double click on the fader", "", ""],
  ["Leave what is open", "", "Esc", ""]
];
function yi() {
  let e = [...new Set(ln().map((t) => t.group))];
  return h(_e, { title: "All keys", wide: !0, children: $("div", { class: "help", children: [
    $("table", { children: [
      h("caption", { class: "spoken", children: "By hand" }),
      h("thead", { children: $("tr", { children: [
        h("th", { scope: "col", children: "What" }),
        h("th", { scope: "col", children: "Mouse" }),
        h("th", { scope: "col", children: "Keys, in the view" }),
        h("th", { scope: "col", children: "Fingers" })
      ] }) }),
      h("tbody", { children: vi.map(([t, n, a, l]) => $("tr", { children: [
        h("th", { scope: "row", children: t }),
        h("td", { children: n }),
        h("td", { children: a.replace("walking keys", gi.value) }),
        h("td", { children: l })
      ] }, t)) })
    ] }),
    $("div", { class: "columns", children: [
      e.map((t) => $("section", { children: [
        h("h3", { children: t }),
        h("dl", { children: ln().filter((n) => n.group === t && n.keys).map((n) => $(Li, { children: [
          h("dt", { children: n.label }),
          h("dd", { children: h("kbd", { children: n.keys }) })
        ] })) })
      ] }, t)),
      $("section", { children: [
        h("h3", { children: "Numbers" }),
        $("dl", { children: [
          h("dt", { children: "Level" }),
          h("dd", { children: "80 %, 450 lm, *0.8, +10, -1/2 stop, full, out" }),
          h("dt", { children: "Colour" }),
          h("dd", { children: "2700K" }),
          h("dt", { children: "Length" }),
          h("dd", { children: `2.4m, 75cm, 8'2", +=0.1` }),
          h("dt", { children: "Angle" }),
          h("dd", { children: "30°" })
        ] })
      ] })
    ] })
  ] }) });
}
var yt = ze(""), Ke = ze(0);
function ki() {
  let e = yt.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((l) => a.toLowerCase().includes(l)), n = ln().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: fi(a.id), run: () => Ua(a.id) }));
  for (let { name: a, camera: l } of Je())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => pi(l, a) });
  if (e.length)
    for (let [a, l] of di.all()) {
      if (n.length > 60) break;
      t(l.name) && n.push({ label: l.name, note: "lamp", why: null, run: () => hi("lamp", a) });
    }
  return n.slice(0, 60);
}
function wi() {
  let e = ki(), t = Math.min(Ke.value, e.length - 1);
  kt(() => {
    yt.value = "", Ke.value = 0;
  }, []), kt(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (Ue.value = null, a.why ? on(a.why, "warn") : setTimeout(a.run, 0));
  };
  return $(_e, { title: "Command palette", children: [
    h(
      "input",
      {
        type: "text",
        role: "combobox",
        class: "command",
        "aria-label": "Command",
        "aria-expanded": "true",
        "aria-controls": "commands",
        "aria-activedescendant": e.length ? `command-${t}` : void 0,
        "aria-autocomplete": "list",
        autofocus: !0,
        placeholder: "What shall be done?",
        value: yt.value,
        onInput: (a) => {
          yt.value = a.currentTarget.value, Ke.value = 0;
        },
        onKeyDown: (a) => {
          let l = { ArrowDown: 1, ArrowUp: -1 }[a.key];
          l && (a.preventDefault(), Ke.value = (t + l + e.length) % Math.max(1, e.length)), a.key === "Enter" && (a.preventDefault(), n(e[t]));
        }
      }
    ),
    $("ul", { class: "commands", id: "commands", role: "listbox", "aria-label": "Commands", children: [
      e.map((a, l) => $(
        "li",
        {
          id: `command-${l}`,
          role: "option",
          "aria-selected": l === t,
          "aria-disabled": a.why !== null,
          title: a.why ?? void 0,
          onPointerMove: () => Ke.value = l,
          onClick: () => n(a),
          children: [
            h("span", { children: a.label }),
            h("kbd", { children: a.note })
          ]
        },
        a.label + l
      )),
      !e.length && h("li", { class: "quiet", role: "option", "aria-selected": "false", "aria-disabled": "true", children: "Nothing is called so." })
    ] })
  ] });
}
var za = ze([]);
mi("links", (e) => za.value = e.links);
function xi({ text: e }) {
  let t = Ka(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((l, r) => l.map((o, i) => o ? `M${i + 4} ${r + 4}h1v1h-1z` : "").join("")).join("");
  return $("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    h("rect", { width: n, height: n, fill: "#fff" }),
    h("path", { d: a, fill: "#000" })
  ] });
}
function Mi() {
  let e = ze(null), t = wt(e).current;
  return kt(() => {
    vt({ do: "links", what: "list" });
  }, []), $(_e, { title: "Share by link", children: [
    h("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    h("ul", { class: "links", children: za.value.map((n) => $("li", { children: [
      h("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      h("code", { children: n.address }),
      $("span", { class: "buttons", children: [
        h("button", { onClick: () => {
          ui(n.address);
        }, children: "Copy" }),
        h("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        h("button", { onClick: () => vt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && h(xi, { text: n.address })
    ] }, n.id)) }),
    $("footer", { children: [
      h("button", { onClick: () => vt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      h("button", { onClick: () => vt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function Ci() {
  let e = wt(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    si({ do: "save", name: n }), Ue.value = null, on(`Saving the version “${n}”.`);
  };
  return $(_e, { title: "Save a version", children: [
    h("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    $("label", { class: "line", children: [
      h("span", { children: "Name" }),
      h("span", { class: "field", children: h("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    h("footer", { children: h("button", { onClick: t, children: "Save" }) })
  ] });
}
var oe = ze(null);
function Si() {
  let e = bi.value?.head, t = wt(null), n = (l) => t.current?.querySelector(`[name=${l}]`)?.value ?? "", a = () => {
    oe.value = 0;
    let [l, r] = [Number(n("width")), Number(n("height"))];
    ii("picture", { format: n("format"), width: l, height: r, batches: Number(n("batches")) }, (o) => {
      o.url ? (oe.value = null, nn(o.name, o.url), Ue.value = null) : oe.value = o.progress ?? 0;
    }, (o) => {
      oe.value = null, on(o, "warn");
    });
  };
  return $(_e, { title: "Save the picture", children: [
    $("div", { ref: t, class: "form", children: [
      $("label", { class: "line", children: [
        h("span", { children: "Format" }),
        $("select", { name: "format", children: [
          h("option", { value: "png", children: "PNG, as it is shown" }),
          h("option", { value: "exr", children: "EXR, the light itself" })
        ] })
      ] }),
      $("label", { class: "line", children: [
        h("span", { children: "Width" }),
        h("input", { type: "number", name: "width", min: 16, max: 16384, value: Math.max(e?.width ?? 0, 640) })
      ] }),
      $("label", { class: "line", children: [
        h("span", { children: "Height" }),
        h("input", { type: "number", name: "height", min: 16, max: 16384, value: Math.max(e?.height ?? 0, 480) })
      ] }),
      $("label", { class: "line", children: [
        h("span", { children: "Batches" }),
        h("input", { type: "number", name: "batches", min: 1, max: 1e5, value: 64 })
      ] })
    ] }),
    oe.value !== null && h("progress", { max: 1, value: oe.value, "aria-label": "Rendering" }),
    $("footer", { children: [
      h("button", { onClick: () => Ua("command"), children: "Copy the command" }),
      h("button", { disabled: oe.value !== null, onClick: a, children: oe.value === null ? "Render and save" : `${ci(oe.value * 100)} %` })
    ] })
  ] });
}
function $i() {
  switch (Ue.value) {
    case "help":
      return h(yi, {});
    case "palette":
      return h(wi, {});
    case "share":
      return h(Mi, {});
    case "save":
      return h(Ci, {});
    case "picture":
      return h(Si, {});
    default:
      return null;
  }
}

// src/later/strip.tsx
import {
  act as _a,
  command as Ja,
  digits as rn,
  fade as xt,
  Field as Ti,
  grids as Xa,
  Icon as Ae,
  looks as Ya,
  luxText as Ve,
  maintenance as Pi,
  meters as ja,
  select as Za,
  selection as Mt,
  signal as Ei,
  status as sn,
  storeLook as Vi
} from "./desk.js";
import { Fragment as Fi, jsx as M, jsxs as H } from "./desk.js";
var un = Ei("looks");
function Ai() {
  return H("section", { class: "looks", "aria-label": "Looks", children: [
    H("header", { children: [
      M("h2", { children: "Looks" }),
      M("button", { class: "tab", onClick: () => un.value = "meters", children: "Meters" }),
      M("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: Vi, children: M(Ae, { name: "plus" }) }),
      M("span", { class: "gap" }),
      H("label", { class: "tint", children: [
        "Fade",
        M(Ti, { label: "Cross-fade", quantity: "seconds", value: xt.value, step: 0.5, set: (e) => xt.value = Math.max(0, e(xt.value)) })
      ] })
    ] }),
    H("ul", { children: [
      Ya.all().map(([e, t], n) => H("li", { class: "look", children: [
        H("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Ja({ do: "look", id: e, what: "recall", seconds: xt.peek() }), children: [
          t.picture && M("img", { src: t.picture, alt: "" }),
          M("span", { children: t.name })
        ] }),
        M(qi, { id: e, name: t.name })
      ] }, e)),
      !Ya.ids.value.length && M("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function qi({ id: e, name: t }) {
  let n = `look-${e}`, a = (i) => {
    let u = i.getBoundingClientRect(), s = document.getElementById(n);
    s?.style.setProperty("left", `${Math.min(u.left, innerWidth - 296)}px`), s?.style.setProperty("bottom", `${innerHeight - u.top + 4}px`), s?.style.setProperty("top", "auto");
  }, l = { popovertarget: n }, r = () => document.getElementById(n)?.hidePopover(), o = (i, u = {}) => {
    r(), Ja({ do: "look", id: e, what: i, ...u });
  };
  return H(Fi, { children: [
    M("button", { class: "icon more", ...l, "aria-label": `More of ${t}`, onPointerDown: (i) => a(i.currentTarget), onFocus: (i) => a(i.currentTarget), children: M(Ae, { name: "more" }) }),
    H("div", { id: n, popover: "auto", class: "menu", children: [
      H("label", { class: "line", children: [
        M("span", { children: "Name" }),
        M("span", { class: "field", children: M("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (i) => o("rename", { name: i.currentTarget.value }) }) })
      ] }),
      M("button", { class: "item", onClick: () => o("update"), children: M("span", { children: "Update to what is set now" }) }),
      M("button", { class: "item", onClick: () => o("recall", { seconds: 0 }), children: M("span", { children: "Recall at once" }) }),
      M("button", { class: "item", onClick: () => o("remove"), children: M("span", { children: "Remove" }) })
    ] })
  ] });
}
var Qa = () => sn.value?.stage === "moving" || sn.value?.stage === "refining" || sn.value?.stage === "loading";
function Ii() {
  let e = Pi.value;
  return H("section", { class: "readings", "aria-label": "Meters and grids", children: [
    H("header", { children: [
      M("h2", { children: "Meters" }),
      M("button", { class: "tab", onClick: () => un.value = "looks", children: "Looks" }),
      M("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => _a("meter-tool"), children: M(Ae, { name: "meter" }) }),
      M("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => _a("grid"), children: M(Ae, { name: "grid" }) }),
      M("button", { onClick: Oa, title: "Save all figures as CSV", children: "CSV" }),
      M("span", { class: "gap" }),
      M("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${rn(e, 2)} maintained` })
    ] }),
    H("ul", { children: [
      ja.all().map(([t, n]) => {
        let a = n.lux, l = !a || a[1] > 0.02 * a[0] || Qa();
        return M("li", { children: H("button", { class: "reading", "aria-pressed": Mt.value?.kind === "meter" && Mt.value.ids.includes(t), onClick: () => Za("meter", t), children: [
          H("span", { class: "tint", children: [
            M(Ae, { name: "meter" }),
            n.name
          ] }),
          M("strong", { class: l ? "unsettled" : "", children: a ? Ve(a[0] * e) : "…" }),
          H("small", { children: [
            a ? `±${Ve(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind
          ] })
        ] }) }, `m${t}`);
      }),
      Xa.all().map(([t, n]) => {
        let a = n.target, l = a && n.mean !== null && n.uniformity !== null && n.mean * e >= a.lux && n.uniformity >= a.uniformity;
        return M("li", { children: H("button", { class: "reading", "aria-pressed": Mt.value?.kind === "grid" && Mt.value.ids.includes(t), onClick: () => Za("grid", t), children: [
          H("span", { class: "tint", children: [
            M(Ae, { name: "grid" }),
            n.name,
            " ",
            a && n.mean !== null && M("b", { class: l ? "met" : "missed", children: l ? "✓" : "✗" })
          ] }),
          M("strong", { class: Qa() ? "unsettled" : "", children: n.mean === null ? "…" : `Ē ${Ve(n.mean * e)}` }),
          H("small", { children: [
            "U₀ ",
            n.uniformity === null ? "…" : rn(n.uniformity, 2),
            " · ",
            n.min === null ? "…" : Ve(n.min * e, !1),
            " to",
            " ",
            n.max === null ? "…" : Ve(n.max * e, !1),
            a ? ` · wants ${Ve(a.lux)}, U₀ ${rn(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !ja.ids.value.length && !Xa.ids.value.length && M("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Ri() {
  return H("div", { class: "strip-parts", "data-tab": un.value, children: [
    M(Ai, {}),
    M(Ii, {})
  ] });
}

// src/later/menus.tsx
import {
  digits as Hi,
  display as Ni,
  Field as el,
  go as Di,
  houseLights as cn,
  Item as ke,
  Range as Oi,
  show as pn,
  theme as tl,
  walking as Wi
} from "./desk.js";
import { Fragment as mn, jsx as P, jsxs as me } from "./desk.js";
function Gi() {
  let e = Je();
  return me(mn, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((t) => P(ke, { id: t }, t)),
    P("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((t) => P(ke, { id: `preset-${t}` }, t)),
    P("hr", {}),
    e.length > 0 && P("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    e.map(({ name: t, camera: n }, a) => P("button", { class: "item", onClick: () => Di(n, t), children: P("span", { children: t }) }, a)),
    e.length > 0 && P("hr", {}),
    P(ke, { id: "walking", label: Wi.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    P(ke, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((t) => P(ke, { id: `hands-${t}` }, t))
  ] });
}
var Bi = ["linear", "reinhard", "filmic"];
function Ki() {
  let e = Ni.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return me(mn, { children: [
    me("fieldset", { children: [
      P("legend", { children: "Tone curve" }),
      P("div", { class: "segments", children: Bi.map((n) => P("button", { "aria-pressed": e.tone === n, onClick: () => pn({ tone: n }), children: n }, n)) })
    ] }),
    me("fieldset", { children: [
      P("legend", { children: "White balance" }),
      me("label", { class: "line", children: [
        P("span", { children: "White" }),
        P(el, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => pn({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      me("label", { class: "line", children: [
        P("span", { children: "Tint" }),
        P(el, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => pn({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    P("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => P(ke, { id: n }, n))
  ] });
}
function Ui() {
  return me(mn, { children: [
    me("label", { class: "line", children: [
      P("span", { children: "House lights" }),
      P(Oi, { label: "House lights", value: cn.value, text: `${Hi(cn.value * 100)} %`, on: (e) => cn.value = Math.max(0.3, e) })
    ] }),
    P("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => P("button", { "aria-pressed": tl.value === e, onClick: () => tl.value = e, children: e }, e)) }),
    P("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => P(ke, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as Ct, cut as zi, digits as nl, edit as al, go as _i, Icon as Xe, Range as Xi, setCut as Yi, storeView as ji, viewName as Zi, views as Qi } from "./desk.js";
import { jsx as Y, jsxs as St } from "./desk.js";
function Ji() {
  let e = Qi.all();
  return St("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    Y("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => Ct("home"), children: Y(Xe, { name: "home" }) }),
    Y("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => Ct("frame"), children: Y(Xe, { name: "frame" }) }),
    Y("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => Ct("back"), children: Y(Xe, { name: "back" }) }),
    Y("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => Ct("forth"), children: Y(Xe, { name: "forth" }) }),
    Y("span", { class: "divide" }),
    e.map(([t, n], a) => St(
      "button",
      {
        class: "saved-view",
        "aria-pressed": Zi.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click to rename, Delete to remove`,
        onClick: () => _i(n, n.name ?? "view"),
        onDblClick: () => {
          let l = prompt("Name of the view", n.name ?? "");
          l && al(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (l) => {
          l.key === "Delete" && (l.stopPropagation(), al(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          Y("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    Y("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: ji, children: Y(Xe, { name: "plus" }) })
  ] });
}
function es() {
  let e = zi.value;
  return e ? St("label", { class: "cut", "data-scroll": !0, children: [
    Y("span", { children: "Cut" }),
    Y(
      Xi,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: `${nl(e.value, 2)} metres`,
        on: (t) => Yi(t * e.most)
      }
    ),
    St("output", { children: [
      nl(e.value, 2),
      " m"
    ] })
  ] }) : null;
}

// src/later/walkpad.tsx
import { padWalk as ts, useRef as ns } from "./desk.js";
import { jsx as ll } from "./desk.js";
function as() {
  let e = ns(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let l = n.type === "pointerup" || n.type === "pointercancel";
    if (!l && !a.hasPointerCapture(n.pointerId)) return;
    let r = a.getBoundingClientRect(), o = (s) => Math.max(-1, Math.min(1, s)), i = l ? 0 : o((n.clientX - r.left) / (r.width / 2) - 1), u = l ? 0 : o(1 - (n.clientY - r.top) / (r.height / 2));
    e.current?.style.setProperty("transform", `translate(${i * 28}px, ${-u * 28}px)`), ts(u, i);
  };
  return ll("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: ll("span", { ref: e }) });
}

// src/later/what.tsx
import {
  addMeter as ls,
  aim as os,
  chosenLamps as ol,
  closeWhat as rl,
  digits as rs,
  hovered as il,
  Icon as is,
  luxText as de,
  nameOf as ss,
  select as us,
  useEffect as cs,
  useRef as ps,
  viewSize as ms,
  what as ds
} from "./desk.js";
import { jsx as G, jsxs as J } from "./desk.js";
var we = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], hs = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function bs() {
  let e = ds.value, t = ps(null);
  if (cs(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = ms.value, l = [...e.lamps].sort((c, g) => we(g) - we(c)), r = l.reduce((c, g) => c + we(g), 0) || 1, o = l.slice(0, 9), i = r - o.reduce((c, g) => c + we(g), 0), u = Math.max(8, Math.min(e.x + 12, n - 332)), s = Math.max(8, Math.min(e.y + 12, a - 120 - 28 * Math.min(l.length, 10))), p = e.lux ? `${de(e.lux[0])} ±${de(e.lux[1], !1)}` : "Measuring…";
  return J(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${u}px`, top: `${s}px` },
      onKeyDown: (c) => {
        c.key === "Escape" && (c.stopPropagation(), rl(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        J("header", { children: [
          G("strong", { class: e.done ? "" : "unsettled", children: p }),
          G("span", { class: "quiet", children: "what lights this" }),
          G("button", { class: "icon", "aria-label": "Close", onClick: rl, children: G(is, { name: "close" }) })
        ] }),
        J("ol", { children: [
          o.map((c) => G(
            "li",
            {
              onPointerEnter: () => il.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => il.value = null,
              children: J("button", { class: "row", onClick: () => us("lamp", c.id), children: [
                G("span", { class: "name", children: ss("lamp", c.id) }),
                J("span", { class: "figure", children: [
                  rs(100 * we(c) / r, we(c) / r < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                J("span", { class: "figure lux", children: [
                  de(we(c)),
                  " ±",
                  de(hs(c), !1)
                ] }),
                J("span", { class: "bar", "aria-hidden": "true", children: [
                  G("i", { class: "direct", style: { width: `${100 * c.direct[0] / r}%` } }),
                  G("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / r}%` } }),
                  G("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / r}%` } })
                ] }),
                J("span", { class: "spoken", children: [
                  "direct ",
                  de(c.direct[0]),
                  ", indirect ",
                  de(c.indirect[0]),
                  ", caustic",
                  " ",
                  de(c.caustic[0])
                ] })
              ] })
            },
            c.id
          )),
          l.length > o.length && J("li", { class: "quiet", children: [
            "and ",
            l.length - o.length,
            " others, ",
            de(i),
            " together"
          ] }),
          !l.length && G("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        J("footer", { children: [
          G("span", { class: "key direct", children: "direct" }),
          G("span", { class: "key indirect", children: "indirect" }),
          G("span", { class: "key caustic", children: "caustic" }),
          G("span", { class: "gap" }),
          ol.value.length > 0 && G("button", { onClick: () => os(ol.peek(), e.hit.point), children: "Aim here" }),
          G("button", { onClick: () => ls(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  eo as Compare,
  es as CutBar,
  qo as Gizmo,
  Br as Inspector,
  Zr as Legend,
  Ui as PageItems,
  Ki as SeeingItems,
  $i as Sheets,
  Ri as Strip,
  Gi as ViewItems,
  Ji as ViewStrip,
  as as WalkPad,
  bs as What
};
