// src/later/actions.ts
import {
  adding as Mi,
  asked as Si,
  ask as Ci,
  back as $i,
  candles as Ya,
  chosenLamps as de,
  clearSolo as Li,
  command as xn,
  compareHeld as Ti,
  copyText as Pi,
  deselect as Vi,
  each as Sn,
  edit as Cn,
  exposeBy as za,
  falseColor as Ei,
  fine as ja,
  forth as Ii,
  frameSelection as Ai,
  go as Ri,
  goHome as qi,
  goInside as Ni,
  goPreset as Hi,
  hands as Fi,
  here as Gi,
  highlight as Oi,
  history as Za,
  lampMarks as Qa,
  lamps as Pt,
  listing as Ja,
  lookOnly as eo,
  maintenance as Di,
  panels as to,
  PRESETS as Wi,
  register as Ki,
  say as Tt,
  scene as Bi,
  selection as io,
  send as Ui,
  sheet as Je,
  show as _i,
  soloSelection as Xi,
  spot as et,
  startTool as Se,
  stepSelection as no,
  storeLook as Yi,
  storeView as zi,
  theme as ao,
  things as oo,
  titleOf as so,
  toggleFalse as ji,
  toggleWipe as Zi,
  travel as lo,
  views as Qi,
  walking as Mn,
  whyNot as _
} from "./desk.js";

// src/later/grouping.ts
import { chosenLamps as Qe, groups as kt, lamps as dr, selection as wt, step as Sa, titleOf as Ca } from "./desk.js";

// src/later/tools.ts
import {
  add as gt,
  adding as Jl,
  chosenLamps as fa,
  distance as er,
  dot as tr,
  edit as ft,
  effect as nr,
  free as ka,
  grids as ba,
  lamps as Ve,
  meters as va,
  normal as wa,
  onTool as ar,
  positionOf as or,
  say as bt,
  scale as ht,
  select as lr,
  step as fn,
  sub as bn,
  titleOf as vt,
  tool as ke,
  untracked as rr,
  up as xa,
  workPlane as ir
} from "./desk.js";

// src/later/area.ts
import { ask as Wl, camera as Kl, cross as Bl, dot as ye, effect as ma, add as dn, normal as Ul, scale as Pe, scene as da, selection as _l, signal as Xl, sub as Yl, tool as zl } from "./desk.js";
var jl = 0.5, Zl = 0.3;
function Ql(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
var mt = (e, t = 0) => e > 2 * t ? e - 2 * t : e;
function gn(e) {
  let [t, n] = [Math.min(...e), Math.max(...e)], a = n >= 2 * t ? t : n, o = a / Math.max(1, Math.round(a / Ql(a)));
  return e.map((l) => Math.max(1, Math.round(l / o)));
}
function ha(e, t, n, a, o) {
  let l = Math.abs(n[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], r = Ul(Bl(n, l)), s = Yl(t.point, e.point), [p, i] = [ye(s, l), ye(s, r)];
  if (Math.abs(p) < 0.05 || Math.abs(i) < 0.05) return null;
  let u = (ee) => ye(ee, n) - a, c = [e, t].every((ee) => ye(ee.normal, n) > 0.7 && u(ee.point) > Zl), h = c ? 0 : jl, m = c ? 0 : o - u(e.point), y = dn(dn(e.point, Pe(n, m)), dn(Pe(l, Math.min(p, 0)), Pe(r, Math.min(i, 0)))), v = [Math.abs(p), Math.abs(i)], [E, N] = gn(v.map((ee) => mt(ee, h)));
  return { corner: y, u: Pe(l, v[0]), v: Pe(r, v[1]), normal: n, columns: E, rows: N, border: h };
}
var ga = Xl(null);
function dt() {
  let e = da.value;
  return ga.value ?? (e ? Math.min(ye(e.bounds[0], e.up), ye(e.bounds[1], e.up)) : 0);
}
var hn = null;
ma(() => {
  let e = Kl.value;
  e && !e.height && (hn = e.eye);
});
ma(() => {
  let e = da.value?.up;
  !e || !hn || zl.value !== "grid" && _l.value?.kind !== "grid" || Wl("ray", { origin: hn, direction: Pe(e, -1) }, (t) => {
    t.hit && (ga.value = ye(t.point, e));
  });
});

// src/later/tools.ts
var _e = null, sr = { lux: 500, uniformity: 0.6 };
nr(() => {
  ke.value !== "grid" && (_e = null);
});
function ur(e) {
  if (!e) return bt("There is nothing at that point.", "warn");
  switch (ke.peek()) {
    case "aim":
      Xe(fa.peek(), e.point), ke.value = null;
      break;
    case "place":
      cr(fa.peek(), e), ke.value = null;
      break;
    case "meter":
      ze(e.point, e.normal), ke.value = null;
      break;
    case "grid":
      if (!_e) {
        _e = e;
        return;
      }
      pr(_e, e), _e = null, ke.value = null;
      break;
    case "add":
      mr(Jl.peek(), e), ke.value = null;
      break;
  }
}
ar(ur);
function Xe(e, t) {
  let n = {};
  for (let a of e) {
    let o = Ve.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: wa(bn(t, o.position)) } });
  }
  if (!Object.keys(n).length) return bt("What is selected shines into all directions: it cannot be aimed.", "warn");
  ft(`Aim ${vt(e)}`, { lamps: n });
}
function Ye(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let l = o.filter((r) => !n.has(r));
    l.length && (lr(t, l[l.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), 3e3);
}
function cr(e, t) {
  let n = Ze(e), a = n.get(e[e.length - 1]);
  if (!a) return bt("What is selected has no place.", "warn");
  let o = (Ve.get(e[e.length - 1])?.place?.radius ?? 0) + 0.02;
  ft(`Put ${vt(e)} on a surface`, je(e, bn(gt(t.point, ht(t.normal, o)), a), n));
}
function ze(e, t) {
  let n = ka(va);
  Ye(va, "meter"), ft("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function pr(e, t) {
  let n = ha(e, t, xa.peek(), rr(dt), ir.peek());
  if (!n) return bt("An area needs two corners that lie apart.", "warn");
  let a = ka(ba);
  Ye(ba, "grid"), ft("Lay a grid", { grids: { [a]: { name: `Area ${a + 1}`, ...n, target: sr } } });
}
var ya = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function mr(e, t) {
  let n = xa.peek(), a = tr(t.normal, n), o = a > 0.7 ? gt(t.point, ht(n, 1.2)) : gt(t.point, ht(t.normal, 0.15)), l = a > 0.7 || a < -0.7 ? ht(n, -1) : t.normal, r = { position: o };
  e !== "point" && e !== "sphere" && (r.direction = l), e === "spot" && Object.assign(r, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (r.radius = 0.15), e === "sphere" && (r.radius = 0.08);
  let s = Ve.all().filter(([, p]) => p.own).length;
  Ye(Ve, "lamp"), fn(`Add ${ya[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${ya[e] ?? e} ${s + 1}`, kind: e, flux: 800, place: r }
  });
}
function yt(e, t, n) {
  !e.length || t < 1 || fn(`Copy ${vt(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function Ma(e) {
  e.length && fn(`Remove ${vt(e)}`, { do: "remove", lamps: e });
}
function je(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = Ve.get(o)?.place, r = n.get(o);
    if (!r) continue;
    let s = gt(r, t), p = l?.aim && er(l.aim, s) > 1e-6 ? { direction: wa(bn(l.aim, s)) } : {};
    a[o] = { place: { position: s, ...p } };
  }
  return { lamps: a };
}
function Ze(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = Ve.get(n), o = a && or(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/grouping.ts
var $a = (e) => {
  let t = dr.get(e)?.group ?? null;
  return t !== null && (kt.get(t)?.lamps.length ?? 0) > 1 ? t : null;
};
function xt() {
  return Qe.value.length < 2 ? "Select two lamps or more first." : wt.value?.kind === "group" && wt.value.ids.length === 1 ? "This is a group already." : null;
}
function La() {
  let e = new Set(kt.all().map(([, n]) => n.name)), t = 1;
  for (; e.has(`Group ${t}`); ) t++;
  Ye(kt, "group"), Sa(`Group ${Ca(Qe.peek())}`, { do: "group", lamps: Qe.peek(), name: `Group ${t}` });
}
function Mt() {
  return Qe.value.some((e) => $a(e) !== null) ? null : "What is selected is in no group.";
}
function Ta() {
  let e = wt.peek(), t = Qe.peek().filter((a) => $a(a) !== null), n = e?.kind === "group" && e.ids.length === 1 ? kt.get(e.ids[0]) : void 0;
  Sa(n ? `Dissolve ${n.name}` : `Take ${Ca(t)} out`, { do: "group", lamps: t }), wt.value = { kind: "lamp", ids: t };
}

// src/later/there.ts
import { add as hr, dot as Pa, go as gr, here as fr, moved as br, scale as vr, spot as yr, sub as kr, up as wr, walking as xr, EYE_HEIGHT as Mr } from "./desk.js";
var Sr = 1.2;
function Cr(e, t, n) {
  let a = kr(n.point, e.eye);
  return e.height || Pa(n.normal, t) < 0.9 || Pa(a, t) > -Sr ? null : br(e, hr(a, vr(t, Mr)));
}
function Va() {
  let [e, t] = [fr(), yr.value];
  return e && t && xr.value === "walk" ? Cr(e, wr.value, t) : null;
}
var Ea = () => Va() ? null : "Point at the floor first, walking.";
function Ia() {
  let e = Va();
  e && gr(e, "there");
}

// src/later/typed.tsx
import { effect as li, handles as ri, keysFirst as ii, role as si, say as ui, scale as ci, selection as pi, signal as mi, tool as di, untracked as hi } from "./desk.js";

// src/later/handles.tsx
import {
  add as Fa,
  chosenLamps as Rr,
  computed as kn,
  editor as qr,
  effect as Nr,
  fitted as Hr,
  Gesture as Fr,
  handles as Gr,
  lamps as Ct,
  lookOnly as Or,
  middle as Dr,
  nameOf as Wr,
  normal as Kr,
  pinhole as Br,
  positionOf as Oa,
  role as Ur,
  selection as _r,
  shown as Xr,
  sub as Yr,
  things as $t,
  titleOf as zr,
  tool as jr,
  turn as Ga,
  useEffect as Zr,
  useRef as Qr,
  viewSize as Jr
} from "./desk.js";

// src/later/gizmo.ts
import { project as Aa, ray as $r } from "./desk.js";
import { across as Lr, add as le, cross as Tr, distance as Pr, dot as me, length as Vr, normal as vn, scale as re, sub as Ee } from "./desk.js";
var Er = "http://www.w3.org/2000/svg", yn = 84, we = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], St = ["x", "y", "z"], Ra = 0.1, Ir = 5 * Math.PI / 180, qa = 48;
function Ha(e, t) {
  let n = (d, f, k) => {
    let w = document.createElementNS(Er, d);
    return w.setAttribute("class", k), f.append(w), w;
  }, a = (d, f, k) => {
    let w = n("g", e, `handle ${d} ${St[f] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), l = we.map((d, f) => a("ring", f, `ring-${St[f]}`)), r = we.map((d, f) => a("plane", f, `plane-${St[f]}`)), s = we.map((d, f) => a("arrow", f, `move-${St[f]}`)), p = a("centre", -1, "move-view"), i = a("aim", -1, "aim"), u = n("text", e, "handle-text"), c = (d, f) => {
    let [k, w, I] = Aa(d.hole, f);
    return I < 0.02 && !d.hole.parallel ? null : [d.fit.x + k * d.fit.scale, d.fit.y + w * d.fit.scale];
  }, h = (d, f) => {
    let k = Aa(d.hole, f)[2];
    return yn / d.fit.scale * d.hole.pixel * (d.hole.parallel ? 1 : Math.max(k, 0.02));
  }, m = (d, f, k = !1) => {
    let w = f.filter(($) => $ !== null), I = w.length < f.length || w.length < 2 ? "" : `M${w.map(($) => `${$[0].toFixed(1)} ${$[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    d.setAttribute("d", I);
  }, y = (d, f, k) => {
    d.setAttribute("d", f ? `M${f[0] - k} ${f[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, v = (d, f) => d.forEach((k) => k.group.classList.toggle("gone", !f));
  function E(d, f) {
    let k = d.position, w = c(f, k), I = h(f, k), $ = d.mode === "move";
    v([...s, ...r, p], $ && w !== null), v(l, !$ && w !== null && d.turns);
    let Y = d.aim ?? (d.direction ? le(k, re(d.direction, 3 * I)) : null);
    if (v([i], Y !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    we.forEach((D, U) => {
      let q = c(f, le(k, re(D, I))), ut = q ? Math.hypot(q[0] - w[0], q[1] - w[1]) < 12 : !0;
      if (s[U].group.classList.toggle("gone", !$ || ut), q && $) {
        let [ve, Be] = [(q[0] - w[0]) / yn, (q[1] - w[1]) / yn], pt = Math.hypot(ve, Be) || 1, [pe, Ue] = [ve / pt, Be / pt], mn = [w[0] + 14 * pe, w[1] + 14 * Ue];
        m(s[U].hit, [mn, q]), s[U].seen.setAttribute("d", `M${mn[0].toFixed(1)} ${mn[1].toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}M${(q[0] - 9 * pe - 4.5 * Ue).toFixed(1)} ${(q[1] - 9 * Ue + 4.5 * pe).toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}L${(q[0] - 9 * pe + 4.5 * Ue).toFixed(1)} ${(q[1] - 9 * Ue - 4.5 * pe).toFixed(1)}`);
      }
      let [We, Ke] = [we[(U + 1) % 3], we[(U + 2) % 3]], Z = Math.abs(me(D, f.hole.parallel ? f.hole.forward : vn(Ee(k, f.hole.eye)))) < 0.15;
      r[U].group.classList.toggle("gone", !$ || Z);
      let ct = (ve, Be) => c(f, le(k, le(re(We, ve * I), re(Ke, Be * I)))), pa = [ct(0.3, 0.3), ct(0.5, 0.3), ct(0.5, 0.5), ct(0.3, 0.5)];
      if (m(r[U].hit, pa, !0), m(r[U].seen, pa, !0), !$) {
        let ve = Array.from({ length: qa + 1 }, (Be, pt) => {
          let pe = 2 * Math.PI * pt / qa;
          return c(f, le(k, le(re(We, Math.cos(pe) * I), re(Ke, Math.sin(pe) * I))));
        });
        m(l[U].hit, ve), m(l[U].seen, ve);
      }
    }), y(p.hit, w, 13), y(p.seen, w, 7);
    let R = Y && c(f, Y);
    m(o, [w, R]), y(i.hit, R, 16), i.seen.setAttribute("d", R ? `M${R[0] - 8} ${R[1]}h16M${R[0]} ${R[1] - 8}v16M${R[0] - 5} ${R[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let N = t.effect(() => {
    let d = t.target.value, f = t.view.value;
    e.classList.toggle("empty", !d || !f), d && f && E(d, f);
  }), ee = (d, f, k) => $r(d.hole, (f.clientX - k.left - d.fit.x) / d.fit.scale, (f.clientY - k.top - d.fit.y) / d.fit.scale);
  function be(d, f, k) {
    d.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let I = t.view.peek();
      if (!I || !t.target.peek()) return;
      let $ = e.getBoundingClientRect(), Y = k(I), R = t.hold(f), D = ee(I, w, $);
      Y(D, !1, { ...R, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), d.setPointerCapture(w.pointerId), d.classList.add("held");
      let U = (Z) => {
        u.textContent = Y(ee(I, Z, $), Z.ctrlKey || Z.metaKey, R), u.setAttribute("x", String(Z.clientX - $.left + 16)), u.setAttribute("y", String(Z.clientY - $.top - 12));
      }, q = (Z) => {
        d.removeEventListener("pointermove", U), d.removeEventListener("pointerup", ut), d.removeEventListener("pointercancel", We), removeEventListener("keydown", Ke, !0), d.classList.remove("held"), u.textContent = "", Z ? R.end() : R.cancel();
      }, ut = () => q(!0), We = () => q(!1), Ke = (Z) => {
        Z.key === "Escape" && (Z.stopPropagation(), q(!1));
      };
      d.addEventListener("pointermove", U), d.addEventListener("pointerup", ut), d.addEventListener("pointercancel", We), addEventListener("keydown", Ke, !0);
    });
  }
  let cn = (d, f, k) => k ? Math.round(d / f) * f : d, pn = (d) => d.map((f) => f.toFixed(2)).join("  ") + " m";
  we.forEach((d, f) => {
    be(s[f].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (I, $, Y) => {
        let R = Ar(k, d, I);
        w ??= R;
        let D = re(d, cn(R - w, Ra, $));
        return Y.move(D), pn(D);
      };
    }), be(r[f].group, "move", () => ua(d)), be(l[f].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (I, $, Y) => {
        let R = Na(k.position, d, I), D = R && vn(Ee(R, k.position), Lr(d));
        if (!D) return "";
        w.at ??= D;
        let U = Math.atan2(me(d, Tr(w.at, D)), me(w.at, D)), q = cn(U, Ir, $);
        return Y.rotate(d, q), `${(q * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), be(p.group, "move", (d) => ua(d.hole.forward)), be(i.group, "aim", (d) => {
    let f = t.target.peek(), k = f.aim ?? le(f.position, re(f.direction, 3 * h(d, f.position))), w = ca(k, d.hole.forward);
    return (I, $, Y) => {
      let R = w(I, $), D = le(k, R);
      return Pr(D, f.position) > 1e-3 && Y.turn(vn(Ee(D, f.position)), D), pn(D);
    };
  });
  function ua(d) {
    let f = ca(t.target.peek().position, d);
    return (k, w, I) => {
      let $ = f(k, w);
      return I.move($), pn($);
    };
  }
  function ca(d, f) {
    let k = null;
    return (w, I) => {
      let $ = Na(d, f, w);
      return $ ? (k ??= $, Ee($, k).map((Y) => cn(Y, Ra, I))) : [0, 0, 0];
    };
  }
  return { stop: N };
}
function Ar(e, t, n) {
  let a = Ee(e, n.origin), o = me(t, n.direction), l = 1 - o * o;
  return l < 1e-6 ? 0 : (o * me(n.direction, a) - me(t, a)) / l;
}
function Na(e, t, n) {
  let a = me(t, n.direction);
  if (Math.abs(a) < 1e-4 * Vr(t)) return null;
  let o = me(Ee(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : le(n.origin, re(n.direction, o));
}

// src/later/handles.tsx
import { jsx as oi } from "./desk.js";
function ei([e, t, n, a], [o, l, r, s]) {
  return [
    a * o + e * s + t * r - n * l,
    a * l - e * r + t * s + n * o,
    a * r + e * l - t * o + n * s,
    a * s - e * o - t * l - n * r
  ];
}
var ti = () => !Or.value && Ur.value !== "watch" && qr.value.you && jr.value !== "aim", Da = kn(() => {
  let e = _r.value;
  if (!e || !ti()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => $t.get(a) && !$t.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = Rr.value.filter((n) => Oa(Ct.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), Wa = (e) => {
  let t = $t.get(e);
  return t?.place?.position ?? (t?.box ? Dr(t.box) : null);
}, Ka = kn(() => {
  let e = Da.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? Oa(Ct.get(t)) : Wa(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? Ct.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: Gr.value
  };
}), ni = kn(() => {
  let e = Xr.value;
  if (Jr.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: Br(e.camera, t, n), fit: Hr(t, n) };
}), Ba = {
  effect: Nr,
  target: Ka,
  view: ni,
  hold(e) {
    let t = Da.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? zr(n) : n.length === 1 ? Wr("thing", n[0]) : `${n.length} things`, l = new Fr(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), r = a === "lamps" ? Ze(n) : new Map(n.map((i) => [i, Wa(i)])), s = new Map(n.map((i) => [i, (a === "lamps" ? Ct : $t).get(i)?.place])), p = (i) => {
      let u = n.map((c) => [c, i(c)]).filter(([, c]) => c);
      l.set({ [a]: Object.fromEntries(u.map(([c, h]) => [c, { place: h }])) });
    };
    return {
      move: (i) => a === "lamps" ? l.set(je(n, i, r)) : p((u) => ({ position: Fa(r.get(u), i) })),
      turn: (i, u) => p((c) => s.get(c)?.direction ? { direction: i, ...u ? { aim: u } : {} } : null),
      rotate: (i, u) => p((c) => {
        let h = s.get(c);
        if (h?.direction) {
          let v = Kr(Ga(h.direction, i, u)), E = h.aim && h.position ? Ga(Yr(h.aim, h.position), i, u) : null;
          return { direction: v, ...E ? { aim: Fa(h.position, E) } : {} };
        }
        let m = Math.sin(u / 2), y = [i[0] * m, i[1] * m, i[2] * m, Math.cos(u / 2)];
        return { rotation: ei(y, h?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => l.end(),
      cancel: () => l.cancel()
    };
  }
}, Ua = (e) => Ka.peek() ? Ba.hold(e) : null;
function ai() {
  let e = Qr(null);
  return Zr(() => Ha(e.current, Ba).stop, []), oi("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/typed.tsx
import { jsx as xi, jsxs as Xa } from "./desk.js";
var gi = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], fi = { Minus: "-", NumpadSubtract: "-", Period: ".", Comma: ".", NumpadDecimal: "." }, _a = { Enter: "keep", Escape: "leave", Backspace: "back" };
function bi({ key: e, code: t }) {
  if (_a[e]) return { does: _a[e] };
  let n = e.length === 1 ? "xyz".indexOf(e.toLowerCase()) : -1;
  if (n >= 0) return { axis: n };
  if (/^\d$/.test(e)) return { sign: e };
  if (/^[.,]$/.test(e)) return { sign: "." };
  if (/^[-−]$/.test(e)) return { sign: "-" };
  if (/^[a-z]$/i.test(e)) return {};
  let a = ["KeyX", "KeyY", "KeyZ"].indexOf(t);
  if (a >= 0) return { axis: a };
  let o = /^(?:Digit|Numpad)(\d)$/.exec(t)?.[1] ?? fi[t];
  return o ? { sign: o } : {};
}
function vi(e, t) {
  return t === "-" ? e.startsWith("-") ? e.slice(1) : `-${e}` : t === "." && e.includes(".") ? e : e.length < 9 ? e + t : e;
}
var yi = (e) => Number(e) || 0, Ie = mi(null), Me = null;
function wn(e) {
  xe(!0), ri.value = e, di.value = null, Ie.value = { what: e, axis: null, text: "" };
}
function xe(e) {
  Ie.peek() && (Ie.value = null, e ? Me?.end() : Me?.cancel(), Me = null);
}
function Lt(e) {
  Ie.value = e;
  let t = gi[e.axis ?? 0], n = yi(e.text);
  e.what === "move" ? Me?.move(ci(t, n)) : Me?.rotate(t, n * Math.PI / 180);
}
function ki(e) {
  let t = Ie.peek();
  if (!t || e.key === "Shift") return !1;
  let n = e.ctrlKey || e.metaKey || e.altKey, { axis: a, sign: o, does: l } = n ? {} : bi(e);
  if (t.axis === null)
    return a === void 0 ? (xe(!1), l === "leave") : (Me = Ua(t.what), Me ? Lt({ ...t, axis: a }) : (xe(!1), ui("Select lamps that have a place, or things that are not locked.", "warn")), !0);
  if (n)
    return xe(!0), !1;
  if (a !== void 0) Lt({ ...t, axis: a });
  else if (o) Lt({ ...t, text: vi(t.text, o) });
  else if (l === "back") Lt({ ...t, text: t.text.slice(0, -1) });
  else if (l) xe(l === "keep");
  else return e.key.length === 1;
  return !0;
}
ii(ki);
addEventListener("pointerdown", (e) => xe(e.button !== 2), !0);
li(() => {
  pi.value, hi(() => xe(!0));
});
function wi() {
  let e = Ie.value;
  if (!e || si.value === "watch") return null;
  let t = e.what === "move" ? "Move" : "Turn";
  return e.axis === null ? Xa("p", { class: "hint", role: "status", children: [
    t,
    ": X, Y or Z, then ",
    e.what === "move" ? "metres" : "degrees",
    "; or drag a handle."
  ] }) : Xa("p", { class: "hint", role: "status", children: [
    t,
    " ",
    e.what === "move" ? "along" : "about",
    " ",
    "XYZ"[e.axis],
    ": ",
    xi("b", { children: e.text || "0" }),
    e.what === "move" ? " m" : "°",
    ". Enter keeps it, Esc takes it back."
  ] });
}

// src/later/actions.ts
var ie = () => _() ?? (de.value.length ? null : "Select a lamp first.");
function Ji() {
  let e = de.peek(), t = !e.some((n) => Pt.get(n)?.on);
  Cn(`${so(e)} ${t ? "on" : "off"}`, { lamps: Sn(e, { on: t }) });
}
function es() {
  let e = de.peek(), t = !e.every((n) => Pt.get(n)?.parked);
  Cn(`${t ? "Park" : "Unpark"} ${so(e)}`, { lamps: Sn(e, { parked: t }) });
}
function ro(e) {
  let t = io.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : oo.ids.peek().filter((a) => oo.get(a)?.hidden);
  if (!n.length) return Tt(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Cn(e ? "Hide things" : "Show hidden things", { things: Sn(n, { hidden: e }) });
}
function ts() {
  let e = de.peek()[0], t = Pt.get(e)?.place, n = Gi();
  if (!t?.position || !t.direction || !n) return Tt("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  Ri({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function ns() {
  Ci("command", {}, (e) => {
    Pi(e.text);
  });
}
var as = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], os = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, ls = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: Ai },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: qi },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: Ni },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: $i },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: Ii },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: zi, why: _ },
  ...Wi.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: os[e],
    keys: `Shift+${t + 1}`,
    run: () => Hi(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      Mn.value = Mn.peek() === "walk" ? "fly" : "walk", Tt(Mn.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "there", group: "View", label: "Go to the floor under the pointer", keys: "double click", run: Ia, why: Ea },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: ts, why: ie },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => no(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => no(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => Se("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => io.value = { kind: "lamp", ids: Pt.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: Vi },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: Ji, why: ie },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Xi, why: () => de.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: Li },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => Oi(!0), why: ie },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: es, why: ie },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => Se("aim"), why: ie },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => et.peek() && Xe(de.peek(), et.peek().point), why: ie },
  { id: "place", group: "Lamps", label: "Put on a surface by pointing", keys: "Shift+N", run: () => Se("place"), why: ie },
  { id: "move", group: "Lamps", label: "Move: handles, or an axis and metres", keys: "G, then X Y Z, 0.5", run: () => wn("move") },
  { id: "turn", group: "Lamps", label: "Turn: handles, or an axis and degrees", keys: "R, then X Y Z, 30", run: () => wn("turn") },
  ...as.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: _,
    run: () => {
      Mi.value = e, Se("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => yt(de.peek(), 1, [0.5, 0, 0]), why: ie },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => Ma(de.peek()), why: ie },
  { id: "group", group: "Lamps", label: "Group: one master for those selected", keys: "Ctrl+G", run: La, why: () => _() ?? xt() },
  { id: "ungroup", group: "Lamps", label: "Dissolve the group, or take lamps out of it", keys: "Ctrl+Shift+G", run: Ta, why: () => _() ?? Mt() },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => ro(!0), why: _ },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => ro(!1), why: _ },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => xn({ do: "undo" }), why: () => _() ?? (Za.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => xn({ do: "redo" }), why: () => _() ?? (Za.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => Je.value = "save", why: _ },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => Je.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: ns },
  { id: "share", group: "Work", label: "Share by link", run: () => Je.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: ji },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = Ei();
      _i({ false_color: { ...Si(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => za(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => za(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => Ui({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => Ti(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: Zi },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: _, run: () => et.peek() ? ze(et.peek().point, et.peek().normal) : Se("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => Se("meter"), why: _ },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => Se("grid"), why: _ },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => xn({ do: "reach", maintenance: Di.peek() }), why: _ },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => Ya.value = Ya.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Yi, why: _ },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => Tt("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => to.value = !to.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => Ja.value = Ja.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => lo.value = lo.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => Qa.value = !Qa.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => ja.value = !ja.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => ao.value = ao.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => eo.value = !eo.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => Fi.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => Je.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => Je.value = "palette" }
];
Ki(ls);
function Vt() {
  return [...(Bi.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...Qi.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/shares.ts
import { ask as rs, computed as is, effect as uo, lamps as ss, output as us, untracked as cs, what as $n } from "./desk.js";
var ps = is(() => $n.value?.hit ?? null), co = (e) => rs("light", { point: e.point, normal: e.normal }, (t) => {
  let n = $n.peek();
  n?.hit === e && ($n.value = {
    ...n,
    lux: t.lux ?? n.lux,
    lamps: t.lamps ?? n.lamps,
    done: t.done !== !1
  });
});
uo(() => {
  let e = ps.value;
  if (!e) return;
  let t = cs(() => co(e)), n = null, a = !0, o = uo(() => {
    for (let [, l] of ss.all()) us(l);
    n !== null && clearTimeout(n), a || (n = window.setTimeout(() => {
      t(), t = co(e);
    }, 250)), a = !1;
  });
  return () => {
    t(), o(), n !== null && clearTimeout(n);
  };
});

// src/later/compare.tsx
import { before as ms, comparing as ds, digits as hs, fitted as gs, useEffect as fs, useRef as bs, viewSize as vs, wipeAt as Ln } from "./desk.js";
import { Fragment as ks, jsx as Tn, jsxs as ws } from "./desk.js";
function ys() {
  let e = ds.value, t = ms.value, n = bs(null);
  if (fs(() => {
    let i = n.current;
    !i || !t || (i.width = t.picture.width, i.height = t.picture.height, i.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = vs.value, o = Ln.value, l = gs(t.picture.width, t.picture.height), r = Math.max(0, Math.min(1, (o * a - l.x) / (t.picture.width * l.scale))), s = (i) => {
    let u = i.currentTarget;
    if (i.stopPropagation(), i.type === "pointerdown") u.setPointerCapture(i.pointerId);
    else if (u.hasPointerCapture(i.pointerId)) {
      let c = u.parentElement.getBoundingClientRect();
      Ln.value = Math.max(0, Math.min(1, (i.clientX - c.left) / c.width));
    }
  }, p = (i) => {
    let u = { ArrowLeft: -0.02, ArrowRight: 0.02 }[i.key];
    u && (i.stopPropagation(), i.preventDefault(), Ln.value = Math.max(0, Math.min(1, o + u)));
  };
  return ws(ks, { children: [
    Tn(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * r}% 0 0)` : "none" }
      }
    ),
    Tn("span", { class: "tag left", children: "before" }),
    e === "wipe" && Tn(
      "div",
      {
        class: "wipe",
        "data-handle": "wipe",
        role: "slider",
        tabIndex: 0,
        "aria-label": "Wipe between before and now",
        "aria-valuemin": 0,
        "aria-valuemax": 100,
        "aria-valuenow": Math.round(o * 100),
        "aria-valuetext": `${hs(o * 100)} % before`,
        style: { left: `${100 * o}%` },
        onPointerDown: s,
        onPointerMove: s,
        onKeyDown: p
      }
    )
  ] });
}

// src/later/inspector.tsx
import { act as dl, deselect as Pu, Icon as zn, penless as jn, selection as Vu, signal as Eu } from "./desk.js";

// src/later/measure.tsx
import {
  add as Ts,
  deselect as Mo,
  digits as Ce,
  dot as Ps,
  edit as Ht,
  grids as Vs,
  Icon as So,
  length as Nt,
  maintained as qe,
  maintenance as Es,
  meters as Is,
  scale as As,
  selection as Co,
  up as wo
} from "./desk.js";

// src/later/figures.tsx
import { maintenance as mo, status as Pn } from "./desk.js";

// src/later/verdict.ts
function po(e, t) {
  let n = ({ value: o, error: l, least: r }) => {
    let s = t ? 0 : l ?? 1 / 0;
    return o - s >= r ? "met" : o + s < r ? "missed" : "open";
  }, a = e.map(n);
  return a.includes("missed") ? "missed" : a.includes("open") ? "open" : "met";
}

// src/later/figures.tsx
import { jsx as yo } from "./desk.js";
var ho = () => Pn.value?.stage === "moving" || Pn.value?.stage === "loading", xs = () => ho() || Pn.value?.stage === "refining", go = { meter: 0.02, grid: 0.05 };
function fo(e, t, n) {
  return e == null || t == null || t > n * e || xs();
}
var Et = ({ lux: e }) => fo(e?.[0], e?.[1], go.meter), It = ({ mean: e, error: t }) => fo(e, t, go.grid), bo = (e, t) => ho() ? "open" : po(e, t === !0);
function At({ lux: e, target: t, done: n }) {
  if (!e || !t) return null;
  let a = mo.value;
  return bo([{ value: e[0] * a, error: e[1] == null ? null : e[1] * a, least: t }], n);
}
function Rt({ mean: e, error: t, uniformity: n, uniformity_error: a, target: o, done: l }) {
  if (!o || e == null || n == null) return null;
  let r = mo.value;
  return bo([
    { value: e * r, error: t == null ? null : t * r, least: o.lux },
    { value: n, error: a ?? null, least: o.uniformity }
  ], l);
}
var vo = {
  met: ["✓", "reaches its target"],
  missed: ["✗", "misses its target"],
  open: ["≈", "within its ± of the target: not decided yet"]
};
function Vn({ of: e }) {
  if (!e) return null;
  let [t, n] = vo[e];
  return yo("b", { class: e, role: "img", "aria-label": n, title: n, children: t });
}
function En({ of: e }) {
  if (!e) return null;
  let [t, n] = vo[e];
  return yo("p", { class: e, children: `${t} ${n[0].toUpperCase()}${n.slice(1)}` });
}

// src/later/parts.tsx
import { Field as ko, Gesture as Ms, Range as Ss, stroke as Cs, useRef as $s } from "./desk.js";
import { jsx as se, jsxs as qt } from "./desk.js";
function A({ title: e, note: t, children: n }) {
  return qt("section", { class: "part", "aria-label": e, children: [
    qt("h3", { children: [
      e,
      t && se("small", { title: t, children: t })
    ] }),
    n
  ] });
}
function K(e) {
  return e.length && e.every((t) => t === e[0]) ? e[0] : null;
}
function P(e) {
  return qt("label", { class: "line", children: [
    se("span", { children: e.label }),
    se(ko, { ...e, label: e.name ?? e.label })
  ] });
}
function Ls(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function Q({ label: e, names: t, quantity: n, value: a, set: o, step: l, disabled: r }) {
  let s = t ?? ["X", "Y", "Z"];
  return qt("div", { class: "line", role: "group", "aria-label": e, children: [
    se("span", { children: e }),
    se("span", { class: "triple", children: s.map((p, i) => se(
      ko,
      {
        label: `${e} ${p}`,
        quantity: n,
        value: a[i],
        text: Ls(a[i], n),
        step: l,
        disabled: r,
        set: (u) => o(i, u)
      },
      p
    )) })
  ] });
}
function Ae({ label: e, name: t, value: n, text: a, patch: o, reset: l, notch: r, class: s, style: p, disabled: i }) {
  let u = $s(null), c = (m) => () => {
    u.current?.[m](), u.current = null;
  }, h = (m) => u.current ? u.current.set(o(m)) : Cs(e + t, t, o(m));
  return se(
    Ss,
    {
      label: e,
      value: n,
      text: a,
      notch: r,
      class: s,
      gradient: p,
      disabled: i,
      begin: () => u.current = new Ms(t),
      on: h,
      end: c("end"),
      cancel: c("cancel"),
      reset: l === void 0 ? void 0 : () => h(l)
    }
  );
}
function Re({ value: e, label: t, set: n }) {
  return se("span", { class: "field name-field", children: se(
    "input",
    {
      type: "text",
      "aria-label": t,
      value: e,
      maxLength: 120,
      spellcheck: !1,
      onChange: (a) => {
        let o = a.currentTarget.value.trim();
        o && o !== e ? n(o) : a.currentTarget.value = e;
      },
      onKeyDown: (a) => {
        a.key === "Enter" && a.currentTarget.blur(), a.key === "Escape" && (a.stopPropagation(), a.currentTarget.value = e, a.currentTarget.blur());
      }
    }
  ) });
}
var ue = (e, t, n) => e.map((a, o) => o === t ? n(a) : a);

// src/later/measure.tsx
import { Fragment as In, jsx as S, jsxs as X } from "./desk.js";
var Rs = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function $o() {
  let e = Co.value?.ids[0], t = Is.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: l, done: r, ...s } = { ...t, ...o };
    Ht(`${t.name}: ${a}`, { meters: { [e]: s } });
  };
  return X(In, { children: [
    S("header", { class: "panel-head", children: S(Re, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    S("p", { class: `crumbs ${Et(t) ? "unsettled" : "known"}`, children: t.lux?.[1] != null ? `${qe(t.lux[0])} ±${qe(t.lux[1], !1)}` : "measuring" }),
    S("div", { class: "scroll", children: X(A, { title: "Meter", children: [
      X("label", { class: "line", children: [
        S("span", { children: "Measures" }),
        S("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: Rs.map(([a, o]) => S("option", { value: a, children: o }, a)) })
      ] }),
      S(Q, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: ue(t.point, a, o) }) }),
      S(P, { label: "At least", quantity: "lux", step: 50, value: t.target ?? 0, set: (a) => n("target", { target: a(t.target ?? 0) || null }) }),
      S(En, { of: At(t) }),
      S(Q, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: ue(t.normal, a, o) }) }),
      X("button", { class: "plain full", onClick: () => {
        Mo(), Ht(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        S(So, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var xo = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function Lo() {
  let e = Co.value?.ids[0], t = Vs.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This grid is gone." });
  let n = Es.value, a = (i, u) => {
    let { name: c, corner: h, u: m, v: y, normal: v, columns: E, rows: N, border: ee, target: be } = { ...t, ...u };
    Ht(`${t.name}: ${i}`, { grids: { [e]: { name: c, corner: h, u: m, v: y, normal: v, columns: E, rows: N, border: ee, target: be } } });
  }, o = (i, u = t.border) => {
    let [c, h] = gn([mt(Nt(t.u), u), mt(Nt(t.v), u)]);
    a(i, { columns: c, rows: h, border: u });
  }, l = Ps(t.corner, wo.value) - dt(), r = (i, u, c) => X(In, { children: [
    S("dt", { children: i }),
    S("dd", { children: u == null ? "…" : c(u) })
  ] }), s = (i, u) => i == null ? "" : ` ±${u(i)}`, p = t.target ?? { lux: 500, uniformity: 0.6 };
  return X(In, { children: [
    S("header", { class: "panel-head", children: S(Re, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
    X("p", { class: "crumbs", children: [
      Ce(Nt(t.u), 2),
      " × ",
      Ce(Nt(t.v), 2),
      " m, ",
      Ce(t.columns * t.rows),
      " points"
    ] }),
    X("div", { class: "scroll", children: [
      S(A, { title: "Figures", note: n === 1 ? "new" : `× ${Ce(n, 2)}`, children: X("dl", { class: `figures ${It(t) ? "unsettled" : ""}`, children: [
        r("Ē", t.mean, (i) => qe(i) + s(t.error, (u) => qe(u, !1))),
        r("E min", t.min, (i) => qe(i)),
        r("E max", t.max, (i) => qe(i)),
        r("U₀ = min / mean", t.uniformity, (i) => Ce(i, 2) + s(t.uniformity_error, (u) => Ce(u, 2))),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => Ce(i, 2))
      ] }) }),
      X(A, { title: "Target", children: [
        S(En, { of: Rt(t) }),
        X("label", { class: "line", children: [
          S("span", { children: "Class" }),
          X("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let u = xo[Number(i.currentTarget.value)];
            a("target", { target: u ? { lux: u[1], uniformity: u[2] } : null });
          }, children: [
            S("option", { value: "", children: t.target ? "choose…" : "none" }),
            xo.map(([i, u, c], h) => X("option", { value: h, children: [
              i,
              ": ",
              u,
              " lx, U₀ ",
              c
            ] }, i)),
            S("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        S(P, { label: "Ē at least", quantity: "lux", step: 50, value: p.lux, set: (i) => a("target", { target: { ...p, lux: i(p.lux) } }) }),
        S(P, { label: "U₀ at least", quantity: "share", step: 0.05, value: p.uniformity, set: (i) => a("target", { target: { ...p, uniformity: i(p.uniformity) } }) })
      ] }),
      X(A, { title: "Area", children: [
        S(Q, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, u) => a("move", { corner: ue(t.corner, i, u) }) }),
        S(P, { label: "Height", name: "Height above the floor", quantity: "length", step: 0.01, value: l, set: (i) => a("height", { corner: Ts(t.corner, As(wo.value, i(l) - l)) }) }),
        S(P, { label: "Border", quantity: "length", step: 0.05, value: t.border ?? 0, set: (i) => o("border", Math.max(0, i(t.border ?? 0))) }),
        S(P, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        S(P, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        S("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: () => o("standard spacing"), children: "Spacing of the standard" }),
        X("button", { class: "plain full", onClick: () => {
          Mo(), Ht(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          S(So, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as ae,
  chosenLamps as Ys,
  dot as Hn,
  edit as Ot,
  format as Fo,
  groups as Dt,
  handles as Ft,
  Icon as He,
  lamps as On,
  layers as zs,
  lumensOf as js,
  normal as Go,
  output as Zs,
  percent as Gn,
  positionOf as Io,
  selection as Oo,
  signal as Do,
  spot as Qs,
  sub as Ao,
  titleOf as Dn,
  tool as Wo,
  toLevel as Ro,
  toTravel as Js,
  typeLevel as Fn,
  up as eu,
  Fade as tu,
  Field as nu,
  wantLevel as qo,
  compass as Ko,
  add as Wt,
  scale as Fe,
  length as au,
  Range as ou,
  strokeLevel as No,
  typeGroupLevel as lu,
  useRef as ru
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as Fs,
  digits as Po,
  edit as Gs,
  fromHex as Os,
  hex as Ds,
  lamps as Vo,
  mired as $e,
  titleOf as Ws
} from "./desk.js";

// src/later/white.ts
import { css as qs, mired as An } from "./desk.js";
function Ns(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((l) => Math.max(0, l));
}
function Hs(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function To(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, l) => {
    let r = An(e) + (An(t) - An(e)) * l / (n - 1);
    return qs(Ns(...Hs(1e6 / r)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as qn, jsx as G, jsxs as he } from "./desk.js";
var tt = 1800, Nn = 1e4, Ks = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], Bs = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], Us = To(tt, Nn), Rn = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t(Vo.get(n).color) }]))
}), _s = (e) => {
  let t = 1e6 / ($e(tt) + ($e(Nn) - $e(tt)) * e);
  return Math.round(t / 10) * 10;
}, Xs = (e) => ($e(e) - $e(tt)) / ($e(Nn) - $e(tt));
function Eo() {
  let e = Fs.value, t = e.map((r) => Vo.get(r)?.color).filter((r) => r !== void 0);
  if (!t.length) return null;
  let n = K(t.map((r) => r.mode)), a = t[0], o = Ws(e), l = (r, s) => Gs(`${o}: ${r}`, Rn(e, s));
  return he(qn, { children: [
    he("div", { class: "line", children: [
      G("span", { children: "Colour" }),
      G("div", { class: "segments", role: "group", "aria-label": "Colour by", children: Bs.map(([r, s]) => G("button", { "aria-pressed": n === r, onClick: () => l(`colour by ${s}`, () => ({ mode: r })), children: s }, r)) })
    ] }),
    n === "kelvin" && he(qn, { children: [
      he("div", { class: "line slide", children: [
        G("span", { children: "White" }),
        G(
          Ae,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: Us,
            value: Xs(a.kelvin),
            text: `${Po(a.kelvin)} kelvin`,
            patch: (r) => Rn(e, () => ({ mode: "kelvin", kelvin: _s(r) }))
          }
        )
      ] }),
      G(
        P,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: K(t.map((r) => r.kelvin)),
          step: 50,
          set: (r) => l("white", (s) => ({ mode: "kelvin", kelvin: r(s.kelvin) }))
        }
      ),
      G("div", { class: "whites", role: "group", "aria-label": "Whites", children: Ks.map(([r, s]) => G("button", { title: s, "aria-label": `${r} kelvin, ${s}`, onClick: () => l(`${r} K`, () => ({ mode: "kelvin", kelvin: r })), children: r }, r)) }),
      he("div", { class: "line slide", children: [
        G("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        G(
          Ae,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${Po(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (r) => Rn(e, () => ({ tint: Math.round((r * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      G(P, { label: "", name: "Tint, typed", quantity: "number", value: K(t.map((r) => r.tint)), step: 1, set: (r) => l("tint", (s) => ({ tint: Math.max(-50, Math.min(50, r(s.tint))) })) })
    ] }),
    n === "rgb" && he(qn, { children: [
      he("label", { class: "line", children: [
        G("span", { children: "Colour" }),
        G("input", { type: "color", class: "pick", "aria-label": "Colour", value: Ds(a.rgb), onChange: (r) => l("colour", () => ({ mode: "rgb", rgb: Os(r.currentTarget.value) })) })
      ] }),
      G(
        Q,
        {
          label: "Linear",
          names: ["R", "G", "B"],
          quantity: "number",
          step: 0.01,
          value: a.rgb,
          set: (r, s) => l("colour", (p) => ({ rgb: p.rgb.map((i, u) => u === r ? Math.max(0, s(i)) : i) }))
        }
      )
    ] }),
    n === "xy" && he("div", { class: "line", role: "group", "aria-label": "Chromaticity", children: [
      G("span", { children: "x, y" }),
      G("span", { class: "triple", children: [0, 1].map((r) => G(
        P,
        {
          label: "xy"[r],
          quantity: "number",
          step: 1e-3,
          value: K(t.map((s) => s.xy[r])),
          set: (s) => l("chromaticity", (p) => ({ xy: p.xy.map((i, u) => u === r ? Math.max(0.01, Math.min(0.9, s(i))) : i) }))
        },
        r
      )) })
    ] }),
    n === null && G("p", { class: "quiet", children: "Colours are given in several ways; choosing one sets it for all." })
  ] });
}

// src/later/lamp.tsx
import { Fragment as Wn, jsx as b, jsxs as O } from "./desk.js";
var Ne = Do(1), Gt = Do([1, 0, 0]), iu = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], Kt = 180 / Math.PI;
function Ho(e, t) {
  let { right: n, ahead: a } = Ko(t), o = -Hn(e, t);
  return [Math.atan2(Hn(e, n), Hn(e, a)) * Kt, Math.asin(Math.max(-1, Math.min(1, o))) * Kt];
}
function su(e, t, n) {
  let { right: a, ahead: o } = Ko(n), [l, r] = [e / Kt, t / Kt], s = Wt(Fe(a, Math.sin(l)), Fe(o, Math.cos(l)));
  return Go(Wt(Fe(s, Math.cos(r)), Fe(n, -Math.sin(r))));
}
function uu({ ids: e, all: t }) {
  let n = t.some((o) => o.place?.direction), a = Oo.value?.kind === "group";
  return O("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    O("button", { "aria-pressed": Wo.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => ae("aim"), children: [
      b(He, { name: "aim" }),
      "Aim"
    ] }),
    b("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => ae("solo"), children: b(He, { name: "solo" }) }),
    b("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => ae("from-lamp"), children: b(He, { name: "eye" }) }),
    b("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => ae("frame"), children: b(He, { name: "frame" }) }),
    b("span", { class: "gap" }),
    xt() === null && b("button", { title: "Group (Ctrl+G): one master for all of them", onClick: () => ae("group"), children: "Group" }),
    Mt() === null && b("button", { title: a ? "Dissolve the group (Ctrl+Shift+G): its lamps stay" : "Take out of the group (Ctrl+Shift+G)", onClick: () => ae("ungroup"), children: a ? "Dissolve" : "Take out" }),
    b("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((o) => o.parked), onClick: () => ae("park"), children: "Park" }),
    b("button", { class: "icon", "aria-label": `Remove ${Dn(e)}`, title: "Remove (Del)", onClick: () => ae("remove"), children: b(He, { name: "bin" }) })
  ] });
}
function cu({ ids: e, all: t }) {
  let n = K(t.map((r) => r.level)), a = js(e), o = t.every((r) => r.free), l = e[e.length - 1];
  return O(A, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    O("div", { class: "line slide", children: [
      b("span", { children: "Level" }),
      b(pu, { id: l })
    ] }),
    O("label", { class: "line", children: [
      b("span", {}),
      b(
        nu,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: K(t.map((r) => r.flux)) ?? void 0,
          step: 0.01,
          set: (r) => Fn(e, r),
          open: qo.value,
          opened: () => qo.value = "",
          id: "level"
        }
      )
    ] }),
    b(
      P,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (r) => Fn(e, (s, p) => r(s * p) / p)
      }
    ),
    O("div", { class: "line", children: [
      b("span", { children: "Stops" }),
      b("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: iu.map(([r, s]) => b("button", { "aria-label": `${s} stop`, onClick: () => Fn(e, (p) => Math.min(1e3, p * 2 ** r)), children: s }, s)) })
    ] }),
    O("p", { class: "sum", children: [
      Fo(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (Dt.get(t[0].group)?.level ?? 1) !== 1 && ` (${Gn(t[0].level)} % × ${Gn(Dt.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    b(Eo, {})
  ] });
}
function pu({ id: e }) {
  let t = ru(null), n = On.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (l) => () => {
    t.current?.[l](), t.current = null;
  };
  return b(
    ou,
    {
      label: "Level",
      value: Js(n.level),
      text: `${Gn(n.level)} %, ${Fo(n.flux * Zs(n), "flux")}`,
      begin: () => t.current = new tu(a),
      on: (l) => t.current ? t.current.to(Ro(l)) : No(a, Ro(l)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => No(a, 1)
    }
  );
}
function nt(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = On.get(o), r = n(l.place ?? {}, l);
    r && (a[o] = { place: r });
  }
  Object.keys(a).length && Ot(`${Dn(e)}: ${t}`, { lamps: a });
}
function mu({ ids: e, all: t }) {
  let n = (o) => K(t.map((l) => l.place?.[o] ?? null)), a = (o) => t.some((l) => l.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : O(A, { title: "Beam", note: "re-trace", children: [
    a("outer") && O(Wn, { children: [
      b(P, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => nt(e, "beam", (l) => l.outer == null ? null : { inner: Math.max(0.1, Math.min(l.outer, o(l.inner ?? l.outer))) }) }),
      b(P, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => nt(e, "beam", (l) => {
        if (l.outer == null) return null;
        let r = Math.max(0.2, Math.min(179, o(l.outer)));
        return { outer: r, inner: Math.min(l.inner ?? r, r) };
      }) })
    ] }),
    a("radius") && b(P, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => nt(e, "radius", (l) => l.radius == null ? null : { radius: Math.max(1e-3, o(l.radius)) }) })
  ] });
}
function du({ ids: e, all: t }) {
  let n = t.filter((c) => Io(c) !== null);
  if (!n.length) return null;
  let a = n.map((c) => Io(c)), o = (c, h) => K(h.map((m) => Math.round(m[c] * 1e4) / 1e4)), l = t.filter((c) => c.place?.direction), r = eu.value, s = l.map((c) => Ho(c.place?.direction, r).map((h) => Math.round(h * 10) / 10)), p = t.map((c) => c.place?.aim).filter((c) => !!c), i = (c, h) => {
    let m = Ze(e), y = {};
    for (let [v, E] of m) {
      let N = [0, 0, 0];
      N[c] = h(E[c]) - E[c], Object.assign(y, je([v], N, m).lamps);
    }
    Ot(`Move ${Dn(e)}`, { lamps: y });
  }, u = (c, h) => nt(e, c ? "tilt" : "pan", (m) => {
    if (!m.direction) return null;
    let y = Ho(m.direction, r);
    y[c] = h(y[c]);
    let v = su(y[0], Math.max(-90, Math.min(90, y[1])), r), E = m.aim && m.position ? au(Ao(m.aim, m.position)) : 0;
    return { direction: v, ...E && m.position ? { aim: Wt(m.position, Fe(v, E)) } : {} };
  });
  return O(A, { title: "Place", note: "re-trace", children: [
    b(Q, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => o(c, a)), set: i }),
    l.length > 0 && O(Wn, { children: [
      b(P, { label: "Pan", quantity: "angle", step: 1, value: K(s.map((c) => c[0])), set: (c) => u(0, c) }),
      b(P, { label: "Tilt", quantity: "angle", step: 1, value: K(s.map((c) => c[1])), set: (c) => u(1, c) }),
      b(
        Q,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: p.length ? [0, 1, 2].map((c) => o(c, p)) : [NaN, NaN, NaN],
          set: (c, h) => nt(e, "aim", (m) => {
            if (!m.direction || !m.position) return null;
            let y = ue(m.aim ?? Wt(m.position, Fe(m.direction, 2)), c, h);
            return { aim: y, direction: Go(Ao(y, m.position)) };
          })
        }
      )
    ] }),
    O("div", { class: "line", children: [
      b("span", { children: "Handles" }),
      O("div", { class: "segments", role: "group", "aria-label": "Handles", children: [
        b("button", { "aria-pressed": Ft.value === "move", onClick: () => Ft.value = "move", children: "Move" }),
        b("button", { "aria-pressed": Ft.value === "turn", onClick: () => Ft.value = "turn", children: "Turn" })
      ] })
    ] }),
    b("button", { class: "plain full", "aria-pressed": Wo.value === "place", onClick: () => ae("place"), children: "Put on a surface by pointing" }),
    l.length > 0 && Qs.value && b("button", { class: "plain full", onClick: () => ae("aim-here"), children: "Aim at the last point" })
  ] });
}
function hu({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : O(A, { title: "Copies along a line", children: [
    b(P, { label: "How many", quantity: "number", step: 1, value: Ne.value, set: (n) => Ne.value = Math.max(1, Math.min(100, Math.round(n(Ne.value)))) }),
    b(Q, { label: "Step", quantity: "length", step: 0.05, value: Gt.value, set: (n, a) => Gt.value = ue(Gt.value, n, a) }),
    O("button", { class: "plain full", onClick: () => yt(e, Ne.value, Gt.value), children: [
      b(He, { name: "copy" }),
      Ne.value === 1 ? "One copy" : `${Ne.value} copies`
    ] })
  ] });
}
function Bo() {
  let e = Ys.value, t = e.map((s) => On.get(s)).filter((s) => !!s);
  if (!t.length) return b("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && Dt.get(n.group), o = Oo.value, l = o?.kind === "group" && o.ids.length === 1 ? Dt.get(o.ids[0]) : void 0, r = n?.layer != null ? zs.value[n.layer] : void 0;
  return O(Wn, { children: [
    b("header", { class: "panel-head", children: l && o ? b(Re, { label: "Name of the group", value: l.name, set: (s) => Ot(`Rename ${l.name}`, { groups: { [o.ids[0]]: { name: s } } }) }) : n ? b(Re, { label: "Name of the lamp", value: n.name, set: (s) => Ot(`Rename ${n.name}`, { lamps: { [e[0]]: { name: s } } }) }) : O("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    b("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((s) => s.on).length} of ${t.length} on` }),
    O("div", { class: "scroll", children: [
      b(uu, { ids: e, all: t }),
      l && o && b(A, { title: "Group", note: "re-mix", children: b(P, { label: "Master", name: "Master of the group", quantity: "level", step: 0.01, value: l.level, set: (s) => lu(o.ids[0], s) }) }),
      b(cu, { ids: e, all: t }),
      b(A, { title: "Photometry", children: b("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      b(mu, { ids: e, all: t }),
      b(du, { ids: e, all: t }),
      b(hu, { ids: e, all: t }),
      b("p", { class: "cost", children: t.every((s) => s.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as Kn,
  candles as Bt,
  command as gu,
  digits as _t,
  edit as Uo,
  Field as _o,
  filterOf as jo,
  go as fu,
  history as bu,
  hovered as Xo,
  Icon as Xt,
  layers as vu,
  lookOnly as Yo,
  maintenance as Ge,
  materials as yu,
  percent as ku,
  scene as wu,
  select as Zo,
  signal as xu,
  singleKeys as zo,
  sub as Mu,
  things as Su,
  travel as Ut,
  Virtual as Qo,
  workPlane as Bn
} from "./desk.js";
import { Fragment as Cu, jsx as x, jsxs as V } from "./desk.js";
function Jo() {
  let e = wu.value;
  if (!e) return null;
  let t = Mu(e.bounds[1], e.bounds[0]);
  return V(Cu, { children: [
    V(A, { title: "Room", children: [
      V("p", { children: [
        t.map((n) => _t(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${_t(e.triangles)} triangles` : ""
      ] }),
      x("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && x("ul", { class: "buttons", children: e.cameras.map((n, a) => x("li", { children: x("button", { onClick: () => fu(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
      e.warnings.length > 0 && V("details", { children: [
        V("summary", { children: [
          e.warnings.length === 1 ? "One remark" : `${e.warnings.length} remarks`,
          " on the file"
        ] }),
        x("ul", { class: "remarks", children: e.warnings.map((n) => x("li", { children: n }, n)) })
      ] })
    ] }),
    V(A, { title: "Figures", children: [
      V("label", { class: "line", children: [
        x("span", { children: "Maintenance" }),
        x(_o, { label: "Maintenance factor", quantity: "share", value: Ge.value, step: 0.05, set: (n) => Ge.value = Math.max(0.1, Math.min(1, n(Ge.value))) })
      ] }),
      V("p", { class: "quiet", children: [
        Ge.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Ge.value === 1 && x("button", { class: "plain", onClick: () => Ge.value = 0.8, children: "0.80" })
      ] }),
      V("label", { class: "line", children: [
        x("span", { children: "Work plane" }),
        x(_o, { label: "Work plane above the floor", quantity: "length", value: Bn.value, step: 0.05, set: (n) => Bn.value = Math.max(0, Math.min(3, n(Bn.value))) })
      ] }),
      V("div", { class: "line", children: [
        x("span", { children: "Unit" }),
        V("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          x("button", { "aria-pressed": Bt.value === "lx", onClick: () => Bt.value = "lx", children: "lx, cd/m²" }),
          x("button", { "aria-pressed": Bt.value === "fc", onClick: () => Bt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    x(A, { title: "Layers of light", children: x("ul", { class: "layers", children: vu.value.map((n, a) => V("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      x("i", { class: "dot", "aria-hidden": "true" }),
      x("span", { children: n.name || `layer ${a + 1}` }),
      x("small", { children: n.held ? "held" : ku(n.of ? n.batches / n.of : 0) + " %" })
    ] }, a)) }) }),
    V(A, { title: "Hands", children: [
      V("div", { class: "line", children: [
        x("span", { children: "Faders" }),
        V("div", { class: "segments", role: "group", "aria-label": "Travel of faders", children: [
          x("button", { "aria-pressed": Ut.value === "square", onClick: () => Ut.value = "square", children: "Square law" }),
          x("button", { "aria-pressed": Ut.value === "linear", onClick: () => Ut.value = "linear", children: "Even" })
        ] })
      ] }),
      V("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: zo.value, onChange: (n) => zo.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      V("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: Yo.value, onChange: (n) => Yo.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var Yt = xu("");
function el({ label: e }) {
  return x("span", { class: "field filter", children: x("input", { type: "text", "aria-label": e, placeholder: "Filter", value: Yt.value, onInput: (t) => Yt.value = t.currentTarget.value }) });
}
function tl() {
  let e = jo(Su, Yt.value);
  return V("div", { class: "listing", children: [
    x(el, { label: "Filter things" }),
    x(
      Qo,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return V("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => Xo.value = { kind: "thing", id: n }, onPointerLeave: () => Xo.value = null, children: [
            x("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => Uo(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: x(Xt, { name: a.hidden ? "eye-off" : "eye" }) }),
            x("button", { class: "row-name", onClick: () => Zo("thing", n), children: x("span", { children: a.name }) }),
            x("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => Uo(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: x(Xt, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function nl() {
  let e = jo(yu, Yt.value);
  return V("div", { class: "listing", children: [
    x(el, { label: "Filter materials" }),
    x(
      Qo,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return V("div", { class: "sheet-row material", role: "listitem", children: [
            x("button", { class: "row-name", onClick: () => Zo("material", n), children: x("span", { children: a.name }) }),
            V("small", { children: [
              a.kind,
              a.reflectance != null ? ` · ρ ${_t(a.reflectance, 2)}` : ""
            ] })
          ] }, n);
        }
      }
    )
  ] });
}
function al() {
  let e = bu.value;
  return V(A, { title: "History", children: [
    V("p", { children: [
      e.steps === 1 ? "One step" : `${_t(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => Kn("undo"), children: [
      x(Xt, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => Kn("redo"), children: [
      x(Xt, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    x("button", { class: "plain full", onClick: () => Kn("save"), children: "Save a version with a name…" }),
    x("button", { class: "plain full", onClick: () => gu({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as Un,
  edit as il,
  fromHex as $u,
  hex as Lu,
  Icon as ol,
  materials as sl,
  middle as ll,
  select as ul,
  selection as cl,
  things as _n
} from "./desk.js";
import { Fragment as Yn, jsx as L, jsxs as z } from "./desk.js";
var Xn = 180 / Math.PI;
function rl(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * Xn : 0;
}
function Tu(e, t) {
  let n = [0, 0, 0, Math.cos(t / Xn / 2)];
  return n[e] = Math.sin(t / Xn / 2), n;
}
function pl() {
  let e = (cl.value?.ids ?? []).filter((p) => _n.get(p)), t = e.map((p) => _n.get(p));
  if (!t.length) return L("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((p) => p.locked), l = (p, i) => il(`${a}: ${p}`, { things: Object.fromEntries(e.map((u, c) => [u, i(t[c])])) }), r = t.map((p) => p.place?.position ?? (p.box ? ll(p.box) : [0, 0, 0])), s = n.box ? [0, 1, 2].map((p) => n.box[1][p] - n.box[0][p]) : null;
  return z(Yn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: a }) }),
    s && z("p", { class: "crumbs", children: [
      s.map((p) => Un(p, 2)).join(" × "),
      " m"
    ] }),
    z("div", { class: "scroll", children: [
      z("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        z("button", { "aria-pressed": t.every((p) => p.hidden), onClick: () => l(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          L(ol, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        z("button", { "aria-pressed": o, onClick: () => l(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          L(ol, { name: o ? "lock" : "unlock" }),
          o ? "Locked" : "Lock"
        ] })
      ] }),
      z(A, { title: "Place", note: "re-trace", children: [
        o && L("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        L(
          Q,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: o,
            value: [0, 1, 2].map((p) => K(r.map((i) => Math.round(i[p] * 1e4) / 1e4))),
            set: (p, i) => l("move", (u) => ({ place: { position: ue(u.place?.position ?? ll(u.box), p, i) } }))
          }
        ),
        [0, 1, 2].map((p) => L(
          P,
          {
            label: `Turn ${"XYZ"[p]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: K(t.map((i) => Math.round(rl(i.place?.rotation, p) * 10) / 10)),
            set: (i) => l("turn", (u) => ({ place: { rotation: Tu(p, i(rl(u.place?.rotation, p))) } }))
          },
          p
        )),
        L(
          P,
          {
            label: "Scale",
            quantity: "number",
            step: 0.05,
            disabled: o,
            value: K(t.map((p) => p.place?.scale ?? 1)),
            set: (p) => l("scale", (i) => ({ place: { scale: Math.max(1e-3, p(i.place?.scale ?? 1)) } }))
          }
        )
      ] }),
      L(A, { title: "Materials", children: L("ul", { class: "buttons", children: n.materials.map((p) => L("li", { children: L("button", { onClick: () => ul("material", p), children: sl.get(p)?.name ?? `material ${p}` }) }, p)) }) })
    ] })
  ] });
}
function ml() {
  let e = cl.value?.ids[0], t = sl.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This material is gone." });
  let n = (i, u) => il(`${t.name}: ${i}`, { materials: { [e]: u } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], r = ((i) => 0.2126 * i[0] + 0.7152 * i[1] + 0.0722 * i[2])(o), s = (i) => o.map((u) => Math.max(0, Math.min(1, r > 1e-4 ? u / r * i : i))), p = (i, u) => t[u] != null && z(Yn, { children: [
    z("div", { class: "line slide", children: [
      L("span", { children: i }),
      L(Ae, { label: i, name: `${t.name}: ${i.toLowerCase()}`, value: t[u], text: Un(t[u], 2), patch: (c) => ({ materials: { [e]: { [u]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    L(P, { label: "", name: `${i}, typed`, quantity: "share", step: 0.01, value: t[u], set: (c) => n(i.toLowerCase(), { [u]: Math.max(0, Math.min(1, c(t[u]))) }) })
  ] });
  return z(Yn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: t.name }) }),
    L("p", { class: "crumbs", children: t.kind }),
    z("div", { class: "scroll", children: [
      z(A, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        z("div", { class: "line slide", children: [
          L("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          L(Ae, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: r, text: Un(r, 2), patch: (i) => ({ materials: { [e]: { [a]: s(Math.min(0.95, i)) } } }) })
        ] }),
        L(P, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(r * 1e3) / 1e3, set: (i) => n("reflectance", { [a]: s(Math.min(0.98, i(r))) }) }),
        z("label", { class: "line", children: [
          L("span", { children: "Colour" }),
          L("input", { type: "color", class: "pick", "aria-label": "Colour", value: Lu(o), onChange: (i) => n("colour", { [a]: $u(i.currentTarget.value) }) })
        ] }),
        p("Roughness", "roughness"),
        p("Gloss", "specular")
      ] }),
      L(A, { title: "On", children: L("ul", { class: "buttons", children: _n.all().filter(([, i]) => i.materials.includes(e)).slice(0, 40).map(([i, u]) => L("li", { children: L("button", { onClick: () => ul("thing", i), children: u.name }) }, i)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as hl, jsx as H, jsxs as zt } from "./desk.js";
var at = ["Scene", "Things", "Materials", "History"], ge = Eu("Scene");
function Iu() {
  let e = { Scene: Jo, Things: tl, Materials: nl, History: al }[ge.value];
  return zt(hl, { children: [
    H("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), ge.value = at[(at.indexOf(ge.value) + a + at.length) % at.length], document.getElementById(`tab-${ge.value}`)?.focus());
    }, children: at.map((n) => H("button", { id: `tab-${n}`, role: "tab", "aria-selected": ge.value === n, "aria-controls": "tab-panel", tabIndex: ge.value === n ? 0 : -1, onClick: () => ge.value = n, children: n }, n)) }),
    H("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${ge.value}`, tabIndex: 0, children: H(e, {}) })
  ] });
}
function Au() {
  let e = Vu.value;
  return e ? zt(hl, { children: [
    zt("nav", { class: "chooser", "aria-label": "Selection", children: [
      H("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => dl("previous"), children: H(zn, { name: "back" }) }),
      H("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => dl("next"), children: H(zn, { name: "forth" }) }),
      H("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      H("span", { class: "gap" }),
      H("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: Pu, children: H(zn, { name: "close" }) })
    ] }),
    jn.value && H("p", { class: "penless", children: jn.value }),
    zt("fieldset", { class: "editing", disabled: jn.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && H(Bo, {}),
      e.kind === "thing" && H(pl, {}),
      e.kind === "material" && H(ml, {}),
      e.kind === "meter" && H($o, {}),
      e.kind === "grid" && H(Lo, {})
    ] })
  ] }) : H(Iu, {});
}

// src/later/legend.tsx
import { asked as Ru, candles as qu, display as Nu, Field as Hu, show as Fu, three as Gu, useRef as Ou } from "./desk.js";
import { jsx as j, jsxs as jt } from "./desk.js";
var Zn = [1, 2, 5];
function Du(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, l = 10 ** Math.floor(Math.log10(o)), r = l * (Zn.find((s) => s * l >= o) ?? 10);
    for (let s = Math.ceil(e / r) * r; s <= t * 1.0001; s += r) a.push(s);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let l of Zn) {
      let r = l * 10 ** o;
      r >= e * 0.999 && r <= t * 1.001 && a.push(r);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function Wu(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var ce = (e, t) => {
  let n = Ru({ ...e, ...t });
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && Fu({ false_color: n });
};
function gl(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return Zn[a] * 10 ** ((n - a) / 3);
}
function Ku() {
  let e = Nu.value.false_color, t = Ou(null);
  if (!e) return null;
  let n = qu.value === "fc", a = e.quantity === "illuminance", o = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", l = n ? a ? 1 / 10.7639 : 0.2919 : 1, r = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, s = e.ticks ?? Du(e.low, e.high, e.scale).map((u) => [u, Wu(u, e)]), p = (u) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: u, from: e[u] };
    },
    onPointerMove: (c) => {
      let h = t.current;
      h?.end === u && ce(e, { [u]: gl(h.from, Math.round((h.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let h = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      h && (c.preventDefault(), c.stopPropagation(), ce(e, { [u]: gl(e[u], h) }));
    }
  }), i = ({ end: u }) => jt("div", { class: "end", children: [
    j(
      "span",
      {
        class: "grip",
        role: "slider",
        tabIndex: 0,
        "aria-label": u === "low" ? "Lower end of the legend" : "Upper end of the legend",
        "aria-valuenow": e[u],
        "aria-valuemin": 1e-3,
        "aria-valuemax": 1e6,
        "aria-valuetext": `${Gu(e[u] * l)} ${o}`,
        ...p(u)
      }
    ),
    j(
      Hu,
      {
        label: u === "low" ? "Lower end" : "Upper end",
        quantity: "number",
        value: Number((e[u] * l).toPrecision(3)),
        set: (c) => ce(e, { [u]: c(e[u] * l) / l })
      }
    )
  ] });
  return jt("aside", { class: "legend", "aria-label": "Legend of false colour", "data-scroll": !0, children: [
    jt("header", { children: [
      j(
        "button",
        {
          "aria-label": `${o}: ${a ? "illuminance" : "luminance"}, change`,
          onClick: () => ce(e, { quantity: a ? "luminance" : "illuminance" }),
          children: o
        }
      ),
      j("button", { "aria-pressed": e.scale === "log", onClick: () => ce(e, { scale: e.scale === "log" ? "linear" : "log" }), children: "log" }),
      j("button", { "aria-pressed": e.lines, onClick: () => ce(e, { lines: !e.lines }), children: "lines" })
    ] }),
    j(i, { end: "high" }),
    j("div", { class: "scale", style: { background: r }, children: s.map(([u, c]) => j("span", { style: { bottom: `${100 * c}%` }, children: String(Number((u * l).toPrecision(2))) }, u)) }),
    j(i, { end: "low" }),
    jt("footer", { children: [
      j("button", { onClick: () => ce(e, { low: 0.1, high: 100, scale: "log" }), children: "0.1–100" }),
      j("button", { onClick: () => ce(e, { low: 1, high: 1e3, scale: "log" }), children: "1–1000" }),
      j(
        "select",
        {
          "aria-label": "Palette",
          value: e.palette,
          onChange: (u) => ce(e, { palette: u.currentTarget.value }),
          children: e.palettes?.map((u) => j("option", { children: u }, u)) ?? j("option", { children: e.palette })
        }
      )
    ] })
  ] });
}

// src/later/sheets.tsx
import {
  allActions as ea,
  act as xl,
  ask as ec,
  command as tc,
  copyText as nc,
  digits as ac,
  go as oc,
  hear as lc,
  lamps as rc,
  say as en,
  select as ic,
  send as Qt,
  sheet as lt,
  shown as sc,
  signal as rt,
  useEffect as ta,
  useLayoutEffect as uc,
  useRef as tn,
  walkNames as cc,
  whyNotTo as pc
} from "./desk.js";

// src/later/csv.ts
import { gridPoint as Bu, grids as Uu, maintenance as _u, meters as Xu, scene as fl } from "./desk.js";
var Yu = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function zu() {
  let e = _u.peek(), t = [["scene", fl.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of Xu.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of Uu.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, l] of Object.entries(a)) t.push([o, l == null ? null : l * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, l) => {
      let r = Bu(n, l % n.columns, Math.floor(l / n.columns));
      t.push([...r.map((s) => s.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(Yu).join(",")).join(`\r
`) + `\r
`;
}
function Qn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function bl() {
  let e = URL.createObjectURL(new Blob([zu()], { type: "text/csv" }));
  Qn(`${fl.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var kl = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], Zt = new Uint8Array(512), Jn = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  Zt[e] = Zt[e + 255] = t, Jn[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var vl = (e, t) => e && t ? Zt[Jn[e] + Jn[t]] : 0;
function ju(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let l = new Array(n.length + 1).fill(0);
    n.forEach((r, s) => {
      l[s] ^= r, l[s + 1] ^= vl(r, Zt[o]);
    }), n = l;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let l = a[o];
    l && n.forEach((r, s) => a[o + s] ^= vl(r, l));
  }
  return a.slice(e.length);
}
function Zu(e, t) {
  let [n, a, o] = kl[t - 1], l = [], r = (h, m) => {
    for (let y = m - 1; y >= 0; y--) l.push(h >> y & 1);
  };
  for (r(4, 4), r(e.length, 8), e.forEach((h) => r(h, 8)), r(0, Math.min(4, n * 8 - l.length)); l.length % 8; ) l.push(0);
  let s = [];
  for (let h = 0; h < l.length; h += 8) s.push(parseInt(l.slice(h, h + 8).join(""), 2));
  for (let h = 236; s.length < n; h ^= 253) s.push(h);
  let p = n / o, i = Array.from({ length: o }, (h, m) => s.slice(m * p, (m + 1) * p)), u = i.map((h) => ju(h, a)), c = (h) => h[0].flatMap((m, y) => h.map((v) => v[y]));
  return [...c(i), ...c(u)];
}
var Qu = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function Ju(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function yl(e) {
  let t = e.length, n = 0, a = 0;
  for (let o of [!1, !0])
    for (let l = 0; l < t; l++) {
      let r = Array.from({ length: t }, (i, u) => o ? e[u][l] : e[l][u]), s = 1;
      for (let i = 1; i <= t; i++)
        i < t && r[i] === r[i - 1] ? s++ : (s >= 5 && (n += s - 2), s = 1);
      let p = r.map(Number).join("");
      for (let i = 0; i + 11 <= t; i++) {
        let u = p.slice(i, i + 11);
        (u === "10111010000" || u === "00001011101") && (n += 40);
      }
    }
  for (let o = 0; o < t; o++)
    for (let l = 0; l < t; l++)
      e[o][l] && a++, l && o && e[o][l] === e[o - 1][l] && e[o][l] === e[o][l - 1] && e[o][l] === e[o - 1][l - 1] && (n += 3);
  return n + 10 * Math.floor(Math.abs(a * 20 / (t * t) - 10));
}
function wl(e) {
  let t = [...new TextEncoder().encode(e)], n = kl.findIndex(([m]) => t.length + 2 <= m) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), l = Array.from({ length: a }, () => new Array(a).fill(!1)), r = (m, y, v) => {
    m < 0 || y < 0 || m >= a || y >= a || (o[y][m] = v, l[y][m] = !0);
  };
  for (let m = 0; m < a; m++)
    r(m, 6, m % 2 === 0), r(6, m, m % 2 === 0);
  for (let [m, y] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let v = -4; v <= 4; v++)
      for (let E = -4; E <= 4; E++) {
        let N = Math.max(Math.abs(E), Math.abs(v));
        r(m + E, y + v, N !== 2 && N !== 4);
      }
  if (n > 1) {
    let m = a - 7;
    for (let y = -2; y <= 2; y++) for (let v = -2; v <= 2; v++) r(m + v, m + y, Math.max(Math.abs(v), Math.abs(y)) !== 1);
  }
  let s = (m) => {
    let y = Ju(m);
    for (let v = 0; v < 15; v++) {
      let E = (y >> v & 1) === 1, N = v < 6 ? v : v < 8 ? v + 1 : a - 15 + v;
      r(8, N, E), r(v < 8 ? a - 1 - v : v < 9 ? 7 : 14 - v, 8, E);
    }
    r(8, a - 8, !0);
  };
  s(0);
  let p = Zu(t, n), i = 0;
  for (let m = a - 1; m > 0; m -= 2) {
    m === 6 && (m = 5);
    for (let y = 0; y < a; y++)
      for (let v of [m, m - 1]) {
        let N = (m + 1 & 2) === 0 ? a - 1 - y : y;
        l[N][v] || (o[N][v] = i < p.length * 8 && (p[i >> 3] >> 7 - (i & 7) & 1) === 1, i++);
      }
  }
  let u = (m) => (s(m), o.map((y, v) => y.map((E, N) => E !== (!l[v][N] && Qu[m](N, v))))), c = u(0), h = yl(c);
  for (let m = 1; m < 8; m++) {
    let y = u(m), v = yl(y);
    v < h && ([c, h] = [y, v]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as wc, jsx as g, jsxs as T } from "./desk.js";
function it({ title: e, wide: t, children: n }) {
  let a = tn(null);
  uc(() => {
    let l = a.current, r = document.activeElement;
    return l.open || l.showModal(), () => r?.focus();
  }, []);
  let o = () => lt.value = null;
  return g(
    "dialog",
    {
      ref: a,
      class: t ? "sheet wide-sheet" : "sheet",
      "aria-label": e,
      onClose: o,
      onClick: (l) => l.target === a.current && o(),
      children: T("div", { class: "sheet-body", children: [
        T("header", { children: [
          g("h2", { children: e }),
          g("span", { class: "gap" }),
          g("button", { onClick: o, children: "Close" })
        ] }),
        n
      ] })
    }
  );
}
var mc = [
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
function dc() {
  let e = [...new Set(ea().map((t) => t.group))];
  return g(it, { title: "All keys", wide: !0, children: T("div", { class: "help", children: [
    T("table", { children: [
      g("caption", { class: "spoken", children: "By hand" }),
      g("thead", { children: T("tr", { children: [
        g("th", { scope: "col", children: "What" }),
        g("th", { scope: "col", children: "Mouse" }),
        g("th", { scope: "col", children: "Keys, in the view" }),
        g("th", { scope: "col", children: "Fingers" })
      ] }) }),
      g("tbody", { children: mc.map(([t, n, a, o]) => T("tr", { children: [
        g("th", { scope: "row", children: t }),
        g("td", { children: n }),
        g("td", { children: a.replace("walking keys", cc.value) }),
        g("td", { children: o })
      ] }, t)) })
    ] }),
    T("div", { class: "columns", children: [
      e.map((t) => T("section", { children: [
        g("h3", { children: t }),
        g("dl", { children: ea().filter((n) => n.group === t && n.keys).map((n) => T(wc, { children: [
          g("dt", { children: n.label }),
          g("dd", { children: g("kbd", { children: n.keys }) })
        ] })) })
      ] }, t)),
      T("section", { children: [
        g("h3", { children: "Numbers" }),
        T("dl", { children: [
          g("dt", { children: "Level" }),
          g("dd", { children: "80 %, 450 lm, *0.8, +10, -1/2 stop, full, out" }),
          g("dt", { children: "Colour" }),
          g("dd", { children: "2700K" }),
          g("dt", { children: "Length" }),
          g("dd", { children: `2.4m, 75cm, 8'2", +=0.1` }),
          g("dt", { children: "Angle" }),
          g("dd", { children: "30°" })
        ] })
      ] })
    ] })
  ] }) });
}
var Jt = rt(""), ot = rt(0);
function hc() {
  let e = Jt.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = ea().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: pc(a.id), run: () => xl(a.id) }));
  for (let { name: a, camera: o } of Vt())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => oc(o, a) });
  if (e.length)
    for (let [a, o] of rc.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => ic("lamp", a) });
    }
  return n.slice(0, 60);
}
function gc() {
  let e = hc(), t = Math.min(ot.value, e.length - 1);
  ta(() => {
    Jt.value = "", ot.value = 0;
  }, []), ta(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (lt.value = null, a.why ? en(a.why, "warn") : setTimeout(a.run, 0));
  };
  return T(it, { title: "Command palette", children: [
    g(
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
        value: Jt.value,
        onInput: (a) => {
          Jt.value = a.currentTarget.value, ot.value = 0;
        },
        onKeyDown: (a) => {
          let o = { ArrowDown: 1, ArrowUp: -1 }[a.key];
          o && (a.preventDefault(), ot.value = (t + o + e.length) % Math.max(1, e.length)), a.key === "Enter" && (a.preventDefault(), n(e[t]));
        }
      }
    ),
    T("ul", { class: "commands", id: "commands", role: "listbox", "aria-label": "Commands", children: [
      e.map((a, o) => T(
        "li",
        {
          id: `command-${o}`,
          role: "option",
          "aria-selected": o === t,
          "aria-disabled": a.why !== null,
          title: a.why ?? void 0,
          onPointerMove: () => ot.value = o,
          onClick: () => n(a),
          children: [
            g("span", { children: a.label }),
            g("kbd", { children: a.note })
          ]
        },
        a.label + o
      )),
      !e.length && g("li", { class: "quiet", role: "option", "aria-selected": "false", "aria-disabled": "true", children: "Nothing is called so." })
    ] })
  ] });
}
var Ml = rt([]);
lc("links", (e) => Ml.value = e.links);
function fc({ text: e }) {
  let t = wl(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, l) => o.map((r, s) => r ? `M${s + 4} ${l + 4}h1v1h-1z` : "").join("")).join("");
  return T("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    g("rect", { width: n, height: n, fill: "#fff" }),
    g("path", { d: a, fill: "#000" })
  ] });
}
function bc() {
  let e = rt(null), t = tn(e).current;
  return ta(() => {
    Qt({ do: "links", what: "list" });
  }, []), T(it, { title: "Share by link", children: [
    g("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    g("ul", { class: "links", children: Ml.value.map((n) => T("li", { children: [
      g("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      g("code", { children: n.address }),
      T("span", { class: "buttons", children: [
        g("button", { onClick: () => {
          nc(n.address);
        }, children: "Copy" }),
        g("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        g("button", { onClick: () => Qt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && g(fc, { text: n.address })
    ] }, n.id)) }),
    T("footer", { children: [
      g("button", { onClick: () => Qt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      g("button", { onClick: () => Qt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function vc() {
  let e = tn(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    tc({ do: "save", name: n }), lt.value = null, en(`Saving the version “${n}”.`);
  };
  return T(it, { title: "Save a version", children: [
    g("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    T("label", { class: "line", children: [
      g("span", { children: "Name" }),
      g("span", { class: "field", children: g("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    g("footer", { children: g("button", { onClick: t, children: "Save" }) })
  ] });
}
var te = rt(null);
function yc() {
  let e = sc.value?.head, t = tn(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    te.value = 0;
    let [o, l] = [Number(n("width")), Number(n("height"))];
    ec("picture", { format: n("format"), width: o, height: l, batches: Number(n("batches")) }, (r) => {
      r.why ? (te.value = null, en(r.why, "warn")) : r.url ? (te.value = null, Qn(r.name, r.url), lt.value = null) : te.value = r.progress ?? 0;
    }, (r) => {
      te.value = null, en(r, "warn");
    });
  };
  return T(it, { title: "Save the picture", children: [
    T("div", { ref: t, class: "form", children: [
      T("label", { class: "line", children: [
        g("span", { children: "Format" }),
        T("select", { name: "format", children: [
          g("option", { value: "png", children: "PNG, as it is shown" }),
          g("option", { value: "exr", children: "EXR, the light itself" })
        ] })
      ] }),
      T("label", { class: "line", children: [
        g("span", { children: "Width" }),
        g("input", { type: "number", name: "width", min: 16, max: 16384, value: Math.max(e?.width ?? 0, 640) })
      ] }),
      T("label", { class: "line", children: [
        g("span", { children: "Height" }),
        g("input", { type: "number", name: "height", min: 16, max: 16384, value: Math.max(e?.height ?? 0, 480) })
      ] }),
      T("label", { class: "line", children: [
        g("span", { children: "Batches" }),
        g("input", { type: "number", name: "batches", min: 1, max: 1e5, value: 64 })
      ] })
    ] }),
    te.value !== null && g("progress", { max: 1, value: te.value, "aria-label": "Rendering" }),
    T("footer", { children: [
      g("button", { onClick: () => xl("command"), children: "Copy the command" }),
      g("button", { disabled: te.value !== null, onClick: a, children: te.value === null ? "Render and save" : te.value ? `${ac(te.value * 100)} %` : "Rendering…" })
    ] })
  ] });
}
function kc() {
  switch (lt.value) {
    case "help":
      return g(dc, {});
    case "palette":
      return g(gc, {});
    case "share":
      return g(bc, {});
    case "save":
      return g(vc, {});
    case "picture":
      return g(yc, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import { act as xc, colorText as Sl, cost as Mc, css as Sc, LevelField as Cc, listed as $c, pickRow as Lc, Power as Tc, select as Pc, three as Vc } from "./desk.js";
import { jsx as J, jsxs as na } from "./desk.js";
function Ec() {
  return na("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    J("span", {}),
    J("span", { children: "Name" }),
    J("span", { children: "Level" }),
    J("span", { children: "lm" }),
    J("span", { children: "White" })
  ] });
}
function Ic({ row: e, index: t, count: n }) {
  let a = $c(e, t, n);
  if (!a) return null;
  let { lamp: o, entry: l } = a;
  return na("div", { class: `sheet-row ${a.state}`, ...a.frame, children: [
    J(Tc, { of: a }),
    J("button", { class: "row-name", "aria-pressed": a.selected, title: o ? Mc(o) : void 0, onClick: (r) => Lc(r, e.kind, e.id), onDblClick: () => xc("frame"), children: J("span", { children: l.name }) }),
    J(Cc, { of: a, label: "level" }),
    J("span", { class: "lumens", children: Vc(a.lumens) }),
    o ? na("button", { class: "tint", "aria-label": `${l.name} colour: ${Sl(o)}`, onClick: () => Pc("lamp", e.id), children: [
      J("i", { class: "swatch", style: { background: Sc(o.swatch) } }),
      Sl(o)
    ] }) : J("span", {})
  ] });
}

// src/later/strip.tsx
import {
  act as aa,
  command as Vl,
  digits as oa,
  fade as nn,
  Field as Ac,
  grids as Cl,
  Icon as De,
  looks as $l,
  luxText as Ll,
  maintained as Oe,
  maintenance as Rc,
  meters as Tl,
  select as Pl,
  selection as an,
  signal as qc,
  storeLook as Nc
} from "./desk.js";
import { Fragment as Dc, jsx as M, jsxs as F } from "./desk.js";
var la = qc("looks");
function Hc() {
  return F("section", { class: "looks", "aria-label": "Looks", children: [
    F("header", { children: [
      M("h2", { children: "Looks" }),
      M("button", { class: "tab", onClick: () => la.value = "meters", children: "Meters" }),
      M("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: Nc, children: M(De, { name: "plus" }) }),
      M("span", { class: "gap" }),
      F("label", { class: "tint", children: [
        "Fade",
        M(Ac, { label: "Cross-fade", quantity: "seconds", value: nn.value, step: 0.5, set: (e) => nn.value = Math.max(0, e(nn.value)) })
      ] })
    ] }),
    F("ul", { children: [
      $l.all().map(([e, t], n) => F("li", { class: "look", children: [
        F("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => Vl({ do: "look", id: e, what: "recall", seconds: nn.peek() }), children: [
          t.picture && M("img", { src: t.picture, alt: "" }),
          M("span", { children: t.name })
        ] }),
        M(Fc, { id: e, name: t.name })
      ] }, e)),
      !$l.ids.value.length && M("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function Fc({ id: e, name: t }) {
  let n = `look-${e}`, a = (s) => {
    let p = s.getBoundingClientRect(), i = document.getElementById(n);
    i?.style.setProperty("left", `${Math.min(p.left, innerWidth - 296)}px`), i?.style.setProperty("bottom", `${innerHeight - p.top + 4}px`), i?.style.setProperty("top", "auto");
  }, o = { popovertarget: n }, l = () => document.getElementById(n)?.hidePopover(), r = (s, p = {}) => {
    l(), Vl({ do: "look", id: e, what: s, ...p });
  };
  return F(Dc, { children: [
    M("button", { class: "icon more", ...o, "aria-label": `More of ${t}`, onPointerDown: (s) => a(s.currentTarget), onFocus: (s) => a(s.currentTarget), children: M(De, { name: "more" }) }),
    F("div", { id: n, popover: "auto", class: "menu", children: [
      F("label", { class: "line", children: [
        M("span", { children: "Name" }),
        M("span", { class: "field", children: M("input", { type: "text", "aria-label": "Name of the look", value: t, onChange: (s) => r("rename", { name: s.currentTarget.value }) }) })
      ] }),
      M("button", { class: "item", onClick: () => r("update"), children: M("span", { children: "Update to what is set now" }) }),
      M("button", { class: "item", onClick: () => r("recall", { seconds: 0 }), children: M("span", { children: "Recall at once" }) }),
      M("button", { class: "item", onClick: () => r("remove"), children: M("span", { children: "Remove" }) })
    ] })
  ] });
}
function Gc() {
  let e = Rc.value;
  return F("section", { class: "readings", "aria-label": "Meters and grids", children: [
    F("header", { children: [
      M("h2", { children: "Meters" }),
      M("button", { class: "tab", onClick: () => la.value = "looks", children: "Looks" }),
      M("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => aa("meter-tool"), children: M(De, { name: "meter" }) }),
      M("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => aa("grid"), children: M(De, { name: "grid" }) }),
      M("button", { onClick: () => aa("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      M("button", { onClick: bl, title: "Save all figures as CSV", children: "CSV" }),
      M("span", { class: "gap" }),
      M("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${oa(e, 2)} maintained` })
    ] }),
    F("ul", { children: [
      Tl.all().map(([t, n]) => {
        let a = n.lux;
        return M("li", { children: F("button", { class: "reading", "aria-pressed": an.value?.kind === "meter" && an.value.ids.includes(t), onClick: () => Pl("meter", t), children: [
          F("span", { class: "tint", children: [
            M(De, { name: "meter" }),
            n.name,
            " ",
            M(Vn, { of: At(n) })
          ] }),
          M("strong", { class: Et(n) ? "unsettled" : "", children: a ? Oe(a[0]) : "…" }),
          F("small", { children: [
            a?.[1] != null ? `±${Oe(a[1], !1)}` : "measuring",
            " ",
            n.kind,
            n.target ? ` · wants ${Ll(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      Cl.all().map(([t, n]) => {
        let a = n.target;
        return M("li", { children: F("button", { class: "reading", "aria-pressed": an.value?.kind === "grid" && an.value.ids.includes(t), onClick: () => Pl("grid", t), children: [
          F("span", { class: "tint", children: [
            M(De, { name: "grid" }),
            n.name,
            " ",
            M(Vn, { of: Rt(n) })
          ] }),
          M("strong", { class: It(n) ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${Oe(n.mean)}${n.error == null ? "" : ` ±${Oe(n.error, !1)}`}` }),
          F("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : oa(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : Oe(n.min, !1),
            " to",
            " ",
            n.max == null ? "…" : Oe(n.max, !1),
            a ? ` · wants ${Ll(a.lux)}, U₀ ${oa(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !Tl.ids.value.length && !Cl.ids.value.length && M("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function Oc() {
  return F("div", { class: "strip-parts", "data-tab": la.value, children: [
    M(Hc, {}),
    M(Gc, {})
  ] });
}

// src/later/menus.tsx
import {
  camera as Al,
  digits as Rl,
  display as Wc,
  Field as ln,
  go as ql,
  houseLights as ra,
  Item as Le,
  Range as Kc,
  show as ia,
  theme as El,
  walking as Bc
} from "./desk.js";
import { Fragment as rn, jsx as C, jsxs as ne } from "./desk.js";
var on = Math.PI / 360;
function Il(e) {
  let t = Al.peek();
  t && ql({ ...t, fov: Math.max(3, Math.min(140, e)) });
}
function Uc() {
  let e = Al.value, t = Vt();
  return ne(rn, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((n) => C(Le, { id: n }, n)),
    C("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((n) => C(Le, { id: `preset-${n}` }, n)),
    C("hr", {}),
    t.length > 0 && C("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    t.map(({ name: n, camera: a }, o) => C("button", { class: "item", onClick: () => ql(a, n), children: C("span", { children: n }) }, o)),
    t.length > 0 && C("hr", {}),
    e && !e.height && ne(rn, { children: [
      ne("label", { class: "line", children: [
        C("span", { children: "Angle" }),
        C(ln, { label: "Vertical angle of view", quantity: "angle", value: e.fov, step: 1, set: (n) => Il(n(e.fov)) })
      ] }),
      ne("label", { class: "line", children: [
        C("span", { children: "Focal length" }),
        C(ln, { label: "Focal length on 36 × 24 mm", quantity: "number", value: Math.round(120 / Math.tan(e.fov * on)) / 10, text: `${Rl(12 / Math.tan(e.fov * on), 1)} mm`, step: 1, set: (n) => Il(Math.atan(12 / Math.max(2, n(12 / Math.tan(e.fov * on)))) / on) })
      ] }),
      C("hr", {})
    ] }),
    C(Le, { id: "walking", label: Bc.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    C(Le, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((n) => C(Le, { id: `hands-${n}` }, n))
  ] });
}
var _c = ["linear", "reinhard", "filmic"];
function Xc() {
  let e = Wc.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return ne(rn, { children: [
    ne("fieldset", { children: [
      C("legend", { children: "Tone curve" }),
      C("div", { class: "segments", children: _c.map((n) => C("button", { "aria-pressed": e.tone === n, onClick: () => ia({ tone: n }), children: n }, n)) })
    ] }),
    ne("fieldset", { children: [
      C("legend", { children: "White balance" }),
      ne("label", { class: "line", children: [
        C("span", { children: "White" }),
        C(ln, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => ia({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      ne("label", { class: "line", children: [
        C("span", { children: "Tint" }),
        C(ln, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => ia({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    C("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => C(Le, { id: n }, n))
  ] });
}
function Yc() {
  return ne(rn, { children: [
    ne("label", { class: "line", children: [
      C("span", { children: "House lights" }),
      C(Kc, { label: "House lights", value: ra.value, text: `${Rl(ra.value * 100)} %`, on: (e) => ra.value = Math.max(0.3, e) })
    ] }),
    C("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => C("button", { "aria-pressed": El.value === e, onClick: () => El.value = e, children: e }, e)) }),
    C("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => C(Le, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as sn, cut as zc, digits as Nl, edit as Hl, go as jc, Icon as st, Range as Zc, setCut as Qc, signal as Jc, storeView as ep, viewName as tp, views as np } from "./desk.js";
import { jsx as W, jsxs as sa } from "./desk.js";
var un = Jc(null);
function ap() {
  let e = np.all();
  return sa("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    W("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => sn("home"), children: W(st, { name: "home" }) }),
    W("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => sn("frame"), children: W(st, { name: "frame" }) }),
    W("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => sn("back"), children: W(st, { name: "back" }) }),
    W("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => sn("forth"), children: W(st, { name: "forth" }) }),
    W("span", { class: "divide" }),
    e.map(([t, n], a) => un.value === t ? W("span", { class: "field", children: W(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (o) => o?.focus(),
        onBlur: (o) => {
          let l = o.currentTarget.value.trim();
          un.value = null, l && l !== n.name && Hl(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (o) => {
          o.stopPropagation(), o.key === "Escape" && (o.currentTarget.value = n.name ?? ""), (o.key === "Enter" || o.key === "Escape") && o.currentTarget.blur();
        }
      }
    ) }, t) : sa(
      "button",
      {
        class: "saved-view",
        "aria-pressed": tp.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click or F2 renames, Delete removes`,
        onClick: () => jc(n, n.name ?? "view"),
        onDblClick: () => un.value = t,
        onKeyDown: (o) => {
          o.key === "F2" && (un.value = t), o.key === "Delete" && (o.stopPropagation(), Hl(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          W("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    W("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: ep, children: W(st, { name: "plus" }) })
  ] });
}
function op() {
  let e = zc.value;
  if (!e) return null;
  let t = e.height === null ? `${Nl(e.value, 2)} m` : `at ${Nl(e.height, 2)} m`;
  return sa("label", { class: "cut", "data-scroll": !0, children: [
    W("span", { children: "Cut" }),
    W(
      Zc,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => Qc(n * e.most)
      }
    ),
    W("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as lp, useRef as rp } from "./desk.js";
import { jsx as Fl } from "./desk.js";
function ip() {
  let e = rp(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let l = a.getBoundingClientRect(), r = (i) => Math.max(-1, Math.min(1, i)), s = o ? 0 : r((n.clientX - l.left) / (l.width / 2) - 1), p = o ? 0 : r(1 - (n.clientY - l.top) / (l.height / 2));
    e.current?.style.setProperty("transform", `translate(${s * 28}px, ${-p * 28}px)`), lp(p, s);
  };
  return Fl("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: Fl("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as Gl,
  closeWhat as Ol,
  digits as sp,
  hovered as Dl,
  Icon as up,
  lamps as cp,
  maintained as fe,
  nameOf as pp,
  select as mp,
  useEffect as dp,
  useRef as hp,
  viewSize as gp,
  what as fp
} from "./desk.js";
import { jsx as B, jsxs as oe } from "./desk.js";
var Te = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], bp = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function vp() {
  let e = fp.value, t = hp(null);
  if (dp(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = gp.value, o = [...e.lamps].sort((c, h) => Te(h) - Te(c)), l = o.reduce((c, h) => c + Te(h), 0) || 1, r = o.slice(0, 9), s = l - r.reduce((c, h) => c + Te(h), 0), p = Math.max(8, Math.min(e.x + 12, n - 332)), i = Math.max(8, Math.min(e.y + 12, a - 150 - 35 * r.length)), u = e.lux ? `${fe(e.lux[0])} ±${fe(e.lux[1], !1)}` : "Measuring…";
  return oe(
    "div",
    {
      class: "what sheetlet",
      role: "dialog",
      "aria-label": "What lights this",
      tabIndex: -1,
      ref: t,
      style: { left: `${p}px`, top: `${i}px` },
      onKeyDown: (c) => {
        c.key === "Escape" && (c.stopPropagation(), Ol(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        oe("header", { children: [
          B("strong", { class: e.done ? "" : "unsettled", children: u }),
          B("span", { class: "quiet", children: "what lights this" }),
          B("button", { class: "icon", "aria-label": "Close", onClick: Ol, children: B(up, { name: "close" }) })
        ] }),
        oe("ol", { children: [
          r.map((c) => B(
            "li",
            {
              onPointerEnter: () => Dl.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => Dl.value = null,
              children: oe("button", { class: "row", onClick: () => mp("lamp", c.id), children: [
                B("span", { class: "name", children: pp("lamp", c.id) }),
                oe("span", { class: "figure", children: [
                  sp(100 * Te(c) / l, Te(c) / l < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                oe("span", { class: "figure lux", children: [
                  fe(Te(c)),
                  " ±",
                  fe(bp(c), !1)
                ] }),
                oe("span", { class: "shares", "aria-hidden": "true", children: [
                  B("i", { class: "direct", style: { width: `${100 * c.direct[0] / l}%` } }),
                  B("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / l}%` } }),
                  B("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / l}%` } })
                ] }),
                oe("span", { class: "spoken", children: [
                  "direct ",
                  fe(c.direct[0]),
                  ", indirect ",
                  fe(c.indirect[0]),
                  ", caustic",
                  " ",
                  fe(c.caustic[0])
                ] })
              ] })
            },
            c.id
          )),
          o.length > r.length && oe("li", { class: "quiet", children: [
            o.length - r.length === 1 ? "one more" : `${o.length - r.length} more together`,
            ": ",
            fe(s)
          ] }),
          !o.length && B("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        oe("footer", { children: [
          B("span", { class: "key direct", children: "direct" }),
          B("span", { class: "key indirect", children: "indirect" }),
          B("span", { class: "key caustic", children: "caustic" }),
          B("span", { class: "gap" }),
          Gl.value.some((c) => cp.get(c)?.place?.direction) && B("button", { onClick: () => Xe(Gl.peek(), e.hit.point), children: "Aim here" }),
          B("button", { onClick: () => ze(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  ys as Compare,
  op as CutBar,
  ai as Gizmo,
  Au as Inspector,
  Ku as Legend,
  Yc as PageItems,
  Xc as SeeingItems,
  Ec as SheetHead,
  Ic as SheetRow,
  kc as Sheets,
  Oc as Strip,
  wi as TypedHint,
  Uc as ViewItems,
  ap as ViewStrip,
  ip as WalkPad,
  vp as What
};
