// src/later/actions.ts
import {
  adding as ri,
  asked as ii,
  ask as si,
  back as ui,
  candles as Ua,
  chosenLamps as me,
  clearSolo as ci,
  command as Mn,
  compareHeld as pi,
  copyText as di,
  deselect as mi,
  each as $n,
  edit as Cn,
  exposeBy as _a,
  falseColor as hi,
  fine as Xa,
  forth as gi,
  frameSelection as fi,
  go as bi,
  goHome as vi,
  goInside as yi,
  goPreset as ki,
  hands as wi,
  here as xi,
  highlight as Mi,
  history as za,
  lampMarks as Ya,
  lamps as Tt,
  listing as ja,
  lookOnly as Za,
  panels as Qa,
  PRESETS as Si,
  register as $i,
  say as Pt,
  scene as Ci,
  selection as oo,
  send as Li,
  sheet as Je,
  show as Pi,
  soloSelection as Ti,
  spot as et,
  startTool as $e,
  stepSelection as Ja,
  storeLook as Vi,
  storeView as Ei,
  theme as eo,
  things as to,
  titleOf as lo,
  toggleFalse as Ii,
  toggleWipe as Ai,
  travel as no,
  views as Ri,
  walking as Sn,
  whyNot as _
} from "./desk.js";

// src/later/grouping.ts
import { chosenLamps as Qe, groups as kt, lamps as sr, selection as wt, step as $a, titleOf as Ca } from "./desk.js";

// src/later/tools.ts
import {
  add as gt,
  adding as zl,
  chosenLamps as ba,
  distance as Yl,
  dot as jl,
  edit as ft,
  effect as Zl,
  free as wa,
  grids as va,
  lamps as Ee,
  meters as ya,
  normal as xa,
  onTool as Ql,
  positionOf as Jl,
  say as bt,
  scale as ht,
  select as er,
  step as bn,
  sub as vn,
  titleOf as vt,
  tool as we,
  untracked as tr,
  up as Ma,
  workPlane as nr
} from "./desk.js";

// src/later/area.ts
import { ask as Hl, camera as Fl, cross as Gl, dot as ke, effect as ma, add as hn, normal as Ol, scale as Ve, scene as ha, selection as Dl, signal as Wl, sub as Kl, tool as Bl } from "./desk.js";
var Ul = 0.5, _l = 0.3;
function Xl(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
var dt = (e, t = 0) => e > 2 * t ? e - 2 * t : e;
function fn(e) {
  let [t, n] = [Math.min(...e), Math.max(...e)], a = n >= 2 * t ? t : n, o = a / Math.max(1, Math.round(a / Xl(a)));
  return e.map((l) => Math.max(1, Math.round(l / o)));
}
function ga(e, t, n, a, o) {
  let l = Math.abs(n[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], r = Ol(Gl(n, l)), s = Kl(t.point, e.point), [p, i] = [ke(s, l), ke(s, r)];
  if (Math.abs(p) < 0.05 || Math.abs(i) < 0.05) return null;
  let u = (ee) => ke(ee, n) - a, c = [e, t].every((ee) => ke(ee.normal, n) > 0.7 && u(ee.point) > _l), h = c ? 0 : Ul, d = c ? 0 : o - u(e.point), y = hn(hn(e.point, Ve(n, d)), hn(Ve(l, Math.min(p, 0)), Ve(r, Math.min(i, 0)))), v = [Math.abs(p), Math.abs(i)], [E, N] = fn(v.map((ee) => dt(ee, h)));
  return { corner: y, u: Ve(l, v[0]), v: Ve(r, v[1]), normal: n, columns: E, rows: N, border: h };
}
var fa = Wl(null);
function mt() {
  let e = ha.value;
  return fa.value ?? (e ? Math.min(ke(e.bounds[0], e.up), ke(e.bounds[1], e.up)) : 0);
}
var gn = null;
ma(() => {
  let e = Fl.value;
  e && !e.height && (gn = e.eye);
});
ma(() => {
  let e = ha.value?.up;
  !e || !gn || Bl.value !== "grid" && Dl.value?.kind !== "grid" || Hl("ray", { origin: gn, direction: Ve(e, -1) }, (t) => {
    t.hit && (fa.value = ke(t.point, e));
  });
});

// src/later/tools.ts
var _e = null, ar = { lux: 500, uniformity: 0.6 };
Zl(() => {
  we.value !== "grid" && (_e = null);
});
function or(e) {
  if (!e) return bt("There is nothing at that point.", "warn");
  switch (we.peek()) {
    case "aim":
      Xe(ba.peek(), e.point), we.value = null;
      break;
    case "place":
      lr(ba.peek(), e), we.value = null;
      break;
    case "meter":
      Ye(e.point, e.normal), we.value = null;
      break;
    case "grid":
      if (!_e) {
        _e = e;
        return;
      }
      rr(_e, e), _e = null, we.value = null;
      break;
    case "add":
      ir(zl.peek(), e), we.value = null;
      break;
  }
}
Ql(or);
function Xe(e, t) {
  let n = {};
  for (let a of e) {
    let o = Ee.get(a)?.place;
    !o?.position || !o.direction || (n[a] = { place: { aim: t, direction: xa(vn(t, o.position)) } });
  }
  if (!Object.keys(n).length) return bt("What is selected shines into all directions: it cannot be aimed.", "warn");
  ft(`Aim ${vt(e)}`, { lamps: n });
}
function ze(e, t) {
  let n = new Set(e.ids.peek()), a = e.ids.subscribe((o) => {
    let l = o.filter((r) => !n.has(r));
    l.length && (er(t, l[l.length - 1]), queueMicrotask(() => a()));
  });
  setTimeout(() => a(), 3e3);
}
function lr(e, t) {
  let n = Ze(e), a = n.get(e[e.length - 1]);
  if (!a) return bt("What is selected has no place.", "warn");
  let o = (Ee.get(e[e.length - 1])?.place?.radius ?? 0) + 0.02;
  ft(`Put ${vt(e)} on a surface`, je(e, vn(gt(t.point, ht(t.normal, o)), a), n));
}
function Ye(e, t) {
  let n = wa(ya);
  ze(ya, "meter"), ft("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function rr(e, t) {
  let n = ga(e, t, Ma.peek(), tr(mt), nr.peek());
  if (!n) return bt("An area needs two corners that lie apart.", "warn");
  let a = wa(va);
  ze(va, "grid"), ft("Lay a grid", { grids: { [a]: { name: `Area ${a + 1}`, ...n, target: ar } } });
}
var ka = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function ir(e, t) {
  let n = Ma.peek(), a = jl(t.normal, n), o = a > 0.7 ? gt(t.point, ht(n, 1.2)) : gt(t.point, ht(t.normal, 0.15)), l = a > 0.7 || a < -0.7 ? ht(n, -1) : t.normal, r = { position: o };
  e !== "point" && e !== "sphere" && (r.direction = l), e === "spot" && Object.assign(r, { inner: 24, outer: 36, ...a > 0.7 ? { aim: t.point } : {} }), e === "disc" && (r.radius = 0.15), e === "sphere" && (r.radius = 0.08);
  let s = Ee.all().filter(([, p]) => p.own).length;
  ze(Ee, "lamp"), bn(`Add ${ka[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${ka[e] ?? e} ${s + 1}`, kind: e, flux: 800, place: r }
  });
}
function yt(e, t, n) {
  !e.length || t < 1 || bn(`Copy ${vt(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function Sa(e) {
  e.length && bn(`Remove ${vt(e)}`, { do: "remove", lamps: e });
}
function je(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = Ee.get(o)?.place, r = n.get(o);
    if (!r) continue;
    let s = gt(r, t), p = l?.aim && Yl(l.aim, s) > 1e-6 ? { direction: xa(vn(l.aim, s)) } : {};
    a[o] = { place: { position: s, ...p } };
  }
  return { lamps: a };
}
function Ze(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let a = Ee.get(n), o = a && Jl(a);
    o && t.set(n, o);
  }
  return t;
}

// src/later/grouping.ts
var La = (e) => {
  let t = sr.get(e)?.group ?? null;
  return t !== null && (kt.get(t)?.lamps.length ?? 0) > 1 ? t : null;
};
function xt() {
  return Qe.value.length < 2 ? "Select two lamps or more first." : wt.value?.kind === "group" && wt.value.ids.length === 1 ? "This is a group already." : null;
}
function Pa() {
  let e = new Set(kt.all().map(([, n]) => n.name)), t = 1;
  for (; e.has(`Group ${t}`); ) t++;
  ze(kt, "group"), $a(`Group ${Ca(Qe.peek())}`, { do: "group", lamps: Qe.peek(), name: `Group ${t}` });
}
function Mt() {
  return Qe.value.some((e) => La(e) !== null) ? null : "What is selected is in no group.";
}
function Ta() {
  let e = wt.peek(), t = Qe.peek().filter((a) => La(a) !== null), n = e?.kind === "group" && e.ids.length === 1 ? kt.get(e.ids[0]) : void 0;
  $a(n ? `Dissolve ${n.name}` : `Take ${Ca(t)} out`, { do: "group", lamps: t }), wt.value = { kind: "lamp", ids: t };
}

// src/later/typed.tsx
import { effect as Wr, handles as Kr, keysFirst as Br, role as Ur, say as _r, scale as Xr, selection as zr, signal as Yr, tool as jr, untracked as Zr } from "./desk.js";

// src/later/handles.tsx
import {
  add as qa,
  chosenLamps as br,
  computed as wn,
  editor as vr,
  effect as yr,
  fitted as kr,
  Gesture as wr,
  handles as xr,
  lamps as $t,
  lookOnly as Mr,
  middle as Sr,
  nameOf as $r,
  normal as Cr,
  pinhole as Lr,
  positionOf as Ha,
  role as Pr,
  selection as Tr,
  shown as Vr,
  sub as Er,
  things as Ct,
  titleOf as Ir,
  tool as Ar,
  turn as Na,
  useEffect as Rr,
  useRef as qr,
  viewSize as Nr
} from "./desk.js";

// src/later/gizmo.ts
import { project as Va, ray as ur } from "./desk.js";
import { across as cr, add as le, cross as pr, distance as dr, dot as de, length as mr, normal as yn, scale as re, sub as Ie } from "./desk.js";
var hr = "http://www.w3.org/2000/svg", kn = 84, xe = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], St = ["x", "y", "z"], Ea = 0.1, gr = 5 * Math.PI / 180, Ia = 48;
function Ra(e, t) {
  let n = (m, f, k) => {
    let w = document.createElementNS(hr, m);
    return w.setAttribute("class", k), f.append(w), w;
  }, a = (m, f, k) => {
    let w = n("g", e, `handle ${m} ${St[f] ?? ""}`);
    return w.setAttribute("data-handle", k), { group: w, hit: n("path", w, "hit"), seen: n("path", w, "seen") };
  }, o = n("path", e, "aim-line"), l = xe.map((m, f) => a("ring", f, `ring-${St[f]}`)), r = xe.map((m, f) => a("plane", f, `plane-${St[f]}`)), s = xe.map((m, f) => a("arrow", f, `move-${St[f]}`)), p = a("centre", -1, "move-view"), i = a("aim", -1, "aim"), u = n("text", e, "handle-text"), c = (m, f) => {
    let [k, w, I] = Va(m.hole, f);
    return I < 0.02 && !m.hole.parallel ? null : [m.fit.x + k * m.fit.scale, m.fit.y + w * m.fit.scale];
  }, h = (m, f) => {
    let k = Va(m.hole, f)[2];
    return kn / m.fit.scale * m.hole.pixel * (m.hole.parallel ? 1 : Math.max(k, 0.02));
  }, d = (m, f, k = !1) => {
    let w = f.filter((C) => C !== null), I = w.length < f.length || w.length < 2 ? "" : `M${w.map((C) => `${C[0].toFixed(1)} ${C[1].toFixed(1)}`).join("L")}${k ? "Z" : ""}`;
    m.setAttribute("d", I);
  }, y = (m, f, k) => {
    m.setAttribute("d", f ? `M${f[0] - k} ${f[1]}a${k} ${k} 0 1 0 ${2 * k} 0a${k} ${k} 0 1 0 ${-2 * k} 0` : "");
  }, v = (m, f) => m.forEach((k) => k.group.classList.toggle("gone", !f));
  function E(m, f) {
    let k = m.position, w = c(f, k), I = h(f, k), C = m.mode === "move";
    v([...s, ...r, p], C && w !== null), v(l, !C && w !== null && m.turns);
    let z = m.aim ?? (m.direction ? le(k, re(m.direction, 3 * I)) : null);
    if (v([i], z !== null && w !== null), !w) {
      o.setAttribute("d", "");
      return;
    }
    xe.forEach((D, U) => {
      let q = c(f, le(k, re(D, I))), ut = q ? Math.hypot(q[0] - w[0], q[1] - w[1]) < 12 : !0;
      if (s[U].group.classList.toggle("gone", !C || ut), q && C) {
        let [ye, Be] = [(q[0] - w[0]) / kn, (q[1] - w[1]) / kn], pt = Math.hypot(ye, Be) || 1, [pe, Ue] = [ye / pt, Be / pt], mn = [w[0] + 14 * pe, w[1] + 14 * Ue];
        d(s[U].hit, [mn, q]), s[U].seen.setAttribute("d", `M${mn[0].toFixed(1)} ${mn[1].toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}M${(q[0] - 9 * pe - 4.5 * Ue).toFixed(1)} ${(q[1] - 9 * Ue + 4.5 * pe).toFixed(1)}L${q[0].toFixed(1)} ${q[1].toFixed(1)}L${(q[0] - 9 * pe + 4.5 * Ue).toFixed(1)} ${(q[1] - 9 * Ue - 4.5 * pe).toFixed(1)}`);
      }
      let [We, Ke] = [xe[(U + 1) % 3], xe[(U + 2) % 3]], Q = Math.abs(de(D, f.hole.parallel ? f.hole.forward : yn(Ie(k, f.hole.eye)))) < 0.15;
      r[U].group.classList.toggle("gone", !C || Q);
      let ct = (ye, Be) => c(f, le(k, le(re(We, ye * I), re(Ke, Be * I)))), da = [ct(0.3, 0.3), ct(0.5, 0.3), ct(0.5, 0.5), ct(0.3, 0.5)];
      if (d(r[U].hit, da, !0), d(r[U].seen, da, !0), !C) {
        let ye = Array.from({ length: Ia + 1 }, (Be, pt) => {
          let pe = 2 * Math.PI * pt / Ia;
          return c(f, le(k, le(re(We, Math.cos(pe) * I), re(Ke, Math.sin(pe) * I))));
        });
        d(l[U].hit, ye), d(l[U].seen, ye);
      }
    }), y(p.hit, w, 13), y(p.seen, w, 7);
    let R = z && c(f, z);
    d(o, [w, R]), y(i.hit, R, 16), i.seen.setAttribute("d", R ? `M${R[0] - 8} ${R[1]}h16M${R[0]} ${R[1] - 8}v16M${R[0] - 5} ${R[1]}a5 5 0 1 0 10 0a5 5 0 1 0 -10 0` : "");
  }
  let N = t.effect(() => {
    let m = t.target.value, f = t.view.value;
    e.classList.toggle("empty", !m || !f), m && f && E(m, f);
  }), ee = (m, f, k) => ur(m.hole, (f.clientX - k.left - m.fit.x) / m.fit.scale, (f.clientY - k.top - m.fit.y) / m.fit.scale);
  function ve(m, f, k) {
    m.addEventListener("pointerdown", (w) => {
      if (w.button !== 0) return;
      w.preventDefault(), w.stopPropagation();
      let I = t.view.peek();
      if (!I || !t.target.peek()) return;
      let C = e.getBoundingClientRect(), z = k(I), R = t.hold(f), D = ee(I, w, C);
      z(D, !1, { ...R, move: () => {
      }, turn: () => {
      }, rotate: () => {
      } }), m.setPointerCapture(w.pointerId), m.classList.add("held");
      let U = (Q) => {
        u.textContent = z(ee(I, Q, C), Q.ctrlKey || Q.metaKey, R), u.setAttribute("x", String(Q.clientX - C.left + 16)), u.setAttribute("y", String(Q.clientY - C.top - 12));
      }, q = (Q) => {
        m.removeEventListener("pointermove", U), m.removeEventListener("pointerup", ut), m.removeEventListener("pointercancel", We), removeEventListener("keydown", Ke, !0), m.classList.remove("held"), u.textContent = "", Q ? R.end() : R.cancel();
      }, ut = () => q(!0), We = () => q(!1), Ke = (Q) => {
        Q.key === "Escape" && (Q.stopPropagation(), q(!1));
      };
      m.addEventListener("pointermove", U), m.addEventListener("pointerup", ut), m.addEventListener("pointercancel", We), addEventListener("keydown", Ke, !0);
    });
  }
  let pn = (m, f, k) => k ? Math.round(m / f) * f : m, dn = (m) => m.map((f) => f.toFixed(2)).join("  ") + " m";
  xe.forEach((m, f) => {
    ve(s[f].group, "move", () => {
      let k = t.target.peek().position, w = null;
      return (I, C, z) => {
        let R = fr(k, m, I);
        w ??= R;
        let D = re(m, pn(R - w, Ea, C));
        return z.move(D), dn(D);
      };
    }), ve(r[f].group, "move", () => ca(m)), ve(l[f].group, "turn", () => {
      let k = t.target.peek(), w = { at: null };
      return (I, C, z) => {
        let R = Aa(k.position, m, I), D = R && yn(Ie(R, k.position), cr(m));
        if (!D) return "";
        w.at ??= D;
        let U = Math.atan2(de(m, pr(w.at, D)), de(w.at, D)), q = pn(U, gr, C);
        return z.rotate(m, q), `${(q * 180 / Math.PI).toFixed(1)}°`;
      };
    });
  }), ve(p.group, "move", (m) => ca(m.hole.forward)), ve(i.group, "aim", (m) => {
    let f = t.target.peek(), k = f.aim ?? le(f.position, re(f.direction, 3 * h(m, f.position))), w = pa(k, m.hole.forward);
    return (I, C, z) => {
      let R = w(I, C), D = le(k, R);
      return dr(D, f.position) > 1e-3 && z.turn(yn(Ie(D, f.position)), D), dn(D);
    };
  });
  function ca(m) {
    let f = pa(t.target.peek().position, m);
    return (k, w, I) => {
      let C = f(k, w);
      return I.move(C), dn(C);
    };
  }
  function pa(m, f) {
    let k = null;
    return (w, I) => {
      let C = Aa(m, f, w);
      return C ? (k ??= C, Ie(C, k).map((z) => pn(z, Ea, I))) : [0, 0, 0];
    };
  }
  return { stop: N };
}
function fr(e, t, n) {
  let a = Ie(e, n.origin), o = de(t, n.direction), l = 1 - o * o;
  return l < 1e-6 ? 0 : (o * de(n.direction, a) - de(t, a)) / l;
}
function Aa(e, t, n) {
  let a = de(t, n.direction);
  if (Math.abs(a) < 1e-4 * mr(t)) return null;
  let o = de(Ie(e, n.origin), t) / a;
  return o < 0 || o > 1e6 ? null : le(n.origin, re(n.direction, o));
}

// src/later/handles.tsx
import { jsx as Dr } from "./desk.js";
function Hr([e, t, n, a], [o, l, r, s]) {
  return [
    a * o + e * s + t * r - n * l,
    a * l - e * r + t * s + n * o,
    a * r + e * l - t * o + n * s,
    a * s - e * o - t * l - n * r
  ];
}
var Fr = () => !Mr.value && Pr.value !== "watch" && vr.value.you && Ar.value !== "aim", Fa = wn(() => {
  let e = Tr.value;
  if (!e || !Fr()) return null;
  if (e.kind === "thing") {
    let n = e.ids.filter((a) => Ct.get(a) && !Ct.get(a)?.locked);
    return n.length ? { kind: "things", ids: n } : null;
  }
  let t = br.value.filter((n) => Ha($t.get(n)));
  return t.length ? { kind: "lamps", ids: t } : null;
}), Ga = (e) => {
  let t = Ct.get(e);
  return t?.place?.position ?? (t?.box ? Sr(t.box) : null);
}, Oa = wn(() => {
  let e = Fa.value;
  if (!e) return null;
  let t = e.ids[e.ids.length - 1], n = e.kind === "lamps" ? Ha($t.get(t)) : Ga(t);
  if (!n) return null;
  let a = e.kind === "lamps" ? $t.get(t)?.place : null;
  return {
    position: n,
    direction: a?.direction ?? null,
    aim: a?.aim ?? null,
    turns: e.kind === "things" || !!a?.direction || !!a?.rotation,
    mode: xr.value
  };
}), Gr = wn(() => {
  let e = Vr.value;
  if (Nr.value, !e) return null;
  let { width: t, height: n } = e.head;
  return { hole: Lr(e.camera, t, n), fit: kr(t, n) };
}), Da = {
  effect: yr,
  target: Oa,
  view: Gr,
  hold(e) {
    let t = Fa.peek(), n = t?.ids ?? [], a = t?.kind ?? "lamps", o = a === "lamps" ? Ir(n) : n.length === 1 ? $r("thing", n[0]) : `${n.length} things`, l = new wr(`${e === "move" ? "Move" : e === "aim" ? "Aim" : "Turn"} ${o}`), r = a === "lamps" ? Ze(n) : new Map(n.map((i) => [i, Ga(i)])), s = new Map(n.map((i) => [i, (a === "lamps" ? $t : Ct).get(i)?.place])), p = (i) => {
      let u = n.map((c) => [c, i(c)]).filter(([, c]) => c);
      l.set({ [a]: Object.fromEntries(u.map(([c, h]) => [c, { place: h }])) });
    };
    return {
      move: (i) => a === "lamps" ? l.set(je(n, i, r)) : p((u) => ({ position: qa(r.get(u), i) })),
      turn: (i, u) => p((c) => s.get(c)?.direction ? { direction: i, ...u ? { aim: u } : {} } : null),
      rotate: (i, u) => p((c) => {
        let h = s.get(c);
        if (h?.direction) {
          let v = Cr(Na(h.direction, i, u)), E = h.aim && h.position ? Na(Er(h.aim, h.position), i, u) : null;
          return { direction: v, ...E ? { aim: qa(h.position, E) } : {} };
        }
        let d = Math.sin(u / 2), y = [i[0] * d, i[1] * d, i[2] * d, Math.cos(u / 2)];
        return { rotation: Hr(y, h?.rotation ?? [0, 0, 0, 1]) };
      }),
      end: () => l.end(),
      cancel: () => l.cancel()
    };
  }
}, Wa = (e) => Oa.peek() ? Da.hold(e) : null;
function Or() {
  let e = qr(null);
  return Rr(() => Ra(e.current, Da).stop, []), Dr("svg", { id: "handles", ref: e, "aria-hidden": "true" });
}

// src/later/typed.tsx
import { jsx as li, jsxs as Ba } from "./desk.js";
var Qr = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], Jr = { Minus: "-", NumpadSubtract: "-", Period: ".", Comma: ".", NumpadDecimal: "." }, Ka = { Enter: "keep", Escape: "leave", Backspace: "back" };
function ei({ key: e, code: t }) {
  if (Ka[e]) return { does: Ka[e] };
  let n = e.length === 1 ? "xyz".indexOf(e.toLowerCase()) : -1;
  if (n >= 0) return { axis: n };
  if (/^\d$/.test(e)) return { sign: e };
  if (/^[.,]$/.test(e)) return { sign: "." };
  if (/^[-−]$/.test(e)) return { sign: "-" };
  if (/^[a-z]$/i.test(e)) return {};
  let a = ["KeyX", "KeyY", "KeyZ"].indexOf(t);
  if (a >= 0) return { axis: a };
  let o = /^(?:Digit|Numpad)(\d)$/.exec(t)?.[1] ?? Jr[t];
  return o ? { sign: o } : {};
}
function ti(e, t) {
  return t === "-" ? e.startsWith("-") ? e.slice(1) : `-${e}` : t === "." && e.includes(".") ? e : e.length < 9 ? e + t : e;
}
var ni = (e) => Number(e) || 0, Ae = Yr(null), Se = null;
function xn(e) {
  Me(!0), Kr.value = e, jr.value = null, Ae.value = { what: e, axis: null, text: "" };
}
function Me(e) {
  Ae.peek() && (Ae.value = null, e ? Se?.end() : Se?.cancel(), Se = null);
}
function Lt(e) {
  Ae.value = e;
  let t = Qr[e.axis ?? 0], n = ni(e.text);
  e.what === "move" ? Se?.move(Xr(t, n)) : Se?.rotate(t, n * Math.PI / 180);
}
function ai(e) {
  let t = Ae.peek();
  if (!t || e.key === "Shift") return !1;
  let n = e.ctrlKey || e.metaKey || e.altKey, { axis: a, sign: o, does: l } = n ? {} : ei(e);
  if (t.axis === null)
    return a === void 0 ? (Me(!1), l === "leave") : (Se = Wa(t.what), Se ? Lt({ ...t, axis: a }) : (Me(!1), _r("Select lamps that have a place, or things that are not locked.", "warn")), !0);
  if (n)
    return Me(!0), !1;
  if (a !== void 0) Lt({ ...t, axis: a });
  else if (o) Lt({ ...t, text: ti(t.text, o) });
  else if (l === "back") Lt({ ...t, text: t.text.slice(0, -1) });
  else if (l) Me(l === "keep");
  else return e.key.length === 1;
  return !0;
}
Br(ai);
addEventListener("pointerdown", (e) => Me(e.button !== 2), !0);
Wr(() => {
  zr.value, Zr(() => Me(!0));
});
function oi() {
  let e = Ae.value;
  if (!e || Ur.value === "watch") return null;
  let t = e.what === "move" ? "Move" : "Turn";
  return e.axis === null ? Ba("p", { class: "hint", role: "status", children: [
    t,
    ": X, Y or Z, then ",
    e.what === "move" ? "metres" : "degrees",
    "; or drag a handle."
  ] }) : Ba("p", { class: "hint", role: "status", children: [
    t,
    " ",
    e.what === "move" ? "along" : "about",
    " ",
    "XYZ"[e.axis],
    ": ",
    li("b", { children: e.text || "0" }),
    e.what === "move" ? " m" : "°",
    ". Enter keeps it, Esc takes it back."
  ] });
}

// src/later/actions.ts
var ie = () => _() ?? (me.value.length ? null : "Select a lamp first.");
function qi() {
  let e = me.peek(), t = !e.some((n) => Tt.get(n)?.on);
  Cn(`${lo(e)} ${t ? "on" : "off"}`, { lamps: $n(e, { on: t }) });
}
function Ni() {
  let e = me.peek(), t = !e.every((n) => Tt.get(n)?.parked);
  Cn(`${t ? "Park" : "Unpark"} ${lo(e)}`, { lamps: $n(e, { parked: t }) });
}
function ao(e) {
  let t = oo.peek(), n = e ? t?.kind === "thing" ? t.ids : [] : to.ids.peek().filter((a) => to.get(a)?.hidden);
  if (!n.length) return Pt(e ? "Select a thing first." : "Nothing is hidden.", "warn");
  Cn(e ? "Hide things" : "Show hidden things", { things: $n(n, { hidden: e }) });
}
function Hi() {
  let e = me.peek()[0], t = Tt.get(e)?.place, n = xi();
  if (!t?.position || !t.direction || !n) return Pt("Select a lamp that has a direction.", "warn");
  let { position: a, direction: o } = t;
  bi({ ...n, eye: a, target: [a[0] + o[0], a[1] + o[1], a[2] + o[2]], height: null, near: null }, "from the lamp");
}
function Fi() {
  si("command", {}, (e) => {
    di(e.text);
  });
}
var Gi = [["point", "point"], ["spot", "spot"], ["disc", "area"], ["sphere", "sphere"]], Oi = {
  plan: "Plan",
  ceiling: "Ceiling, seen from below",
  north: "Elevation ahead",
  east: "Elevation to the right",
  south: "Elevation back",
  west: "Elevation to the left"
}, Di = [
  { id: "frame", group: "View", label: "Frame the selection", keys: "F", run: fi },
  { id: "home", group: "View", label: "Home: the view at the beginning", keys: "Home", run: vi },
  { id: "inside", group: "View", label: "Inside again", keys: "Shift+0", run: yi },
  { id: "back", group: "View", label: "The view before", keys: "Alt+←", run: ui },
  { id: "forth", group: "View", label: "The view after", keys: "Alt+→", run: gi },
  { id: "store-view", group: "View", label: "Store this view", keys: "Alt+0", run: Ei, why: _ },
  ...Si.map((e, t) => ({
    id: `preset-${e}`,
    group: "View",
    label: Oi[e],
    keys: `Shift+${t + 1}`,
    run: () => ki(e)
  })),
  {
    id: "walking",
    group: "View",
    label: "Walk or fly",
    keys: "V",
    run: () => {
      Sn.value = Sn.peek() === "walk" ? "fly" : "walk", Pt(Sn.peek() === "walk" ? "Walking, the eye 1.60 m above the floor" : "Flying");
    }
  },
  { id: "from-lamp", group: "View", label: "View from the lamp", keys: "Shift+L", run: Hi, why: ie },
  { id: "next", group: "Select", label: "Next", keys: "]", run: () => Ja(1) },
  { id: "previous", group: "Select", label: "Previous", keys: "[", run: () => Ja(-1) },
  { id: "marquee", group: "Select", label: "Select lamps by dragging around them", keys: "M", run: () => $e("marquee") },
  { id: "all-lamps", group: "Select", label: "Select all lamps", keys: "Ctrl+A", run: () => oo.value = { kind: "lamp", ids: Tt.ids.peek() } },
  { id: "none", group: "Select", label: "Select nothing", keys: "Esc", run: mi },
  { id: "on-off", group: "Lamps", label: "On or off", keys: "O", run: qi, why: ie },
  { id: "solo", group: "Lamps", label: "Solo", keys: "I", run: Ti, why: () => me.value.length ? null : "Select a lamp first." },
  { id: "unsolo", group: "Lamps", label: "End solo", keys: "Shift+I", run: ci },
  { id: "highlight", group: "Lamps", label: "Highlight as long as the key is held", keys: "hold L", run: () => Mi(!0), why: ie },
  { id: "park", group: "Lamps", label: "Park: off, and not traced", keys: "Shift+O", run: Ni, why: ie },
  { id: "aim", group: "Lamps", label: "Aim by pointing", keys: "T", run: () => $e("aim"), why: ie },
  { id: "aim-here", group: "Lamps", label: "Aim at the point under the pointer", keys: "Shift+T", run: () => et.peek() && Xe(me.peek(), et.peek().point), why: ie },
  { id: "place", group: "Lamps", label: "Put on a surface by pointing", keys: "Shift+N", run: () => $e("place"), why: ie },
  { id: "move", group: "Lamps", label: "Move: handles, or an axis and metres", keys: "G, then X Y Z, 0.5", run: () => xn("move") },
  { id: "turn", group: "Lamps", label: "Turn: handles, or an axis and degrees", keys: "R, then X Y Z, 30", run: () => xn("turn") },
  ...Gi.map(([e, t]) => ({
    id: `add-${e}`,
    group: "Lamps",
    label: `Add a ${t} lamp by pointing`,
    keys: e === "spot" ? "N" : void 0,
    why: _,
    run: () => {
      ri.value = e, $e("add");
    }
  })),
  { id: "duplicate", group: "Lamps", label: "Duplicate", keys: "Ctrl+D", run: () => yt(me.peek(), 1, [0.5, 0, 0]), why: ie },
  { id: "remove", group: "Lamps", label: "Remove", keys: "Del", run: () => Sa(me.peek()), why: ie },
  { id: "group", group: "Lamps", label: "Group: one master for those selected", keys: "Ctrl+G", run: Pa, why: () => _() ?? xt() },
  { id: "ungroup", group: "Lamps", label: "Dissolve the group, or take lamps out of it", keys: "Ctrl+Shift+G", run: Ta, why: () => _() ?? Mt() },
  { id: "hide", group: "Things", label: "Hide", keys: "H", run: () => ao(!0), why: _ },
  { id: "unhide", group: "Things", label: "Show what is hidden", keys: "Alt+H", run: () => ao(!1), why: _ },
  { id: "undo", group: "Work", label: "Undo", keys: "Ctrl+Z", run: () => Mn({ do: "undo" }), why: () => _() ?? (za.value.undo === null ? "There is nothing to undo." : null) },
  { id: "redo", group: "Work", label: "Redo", keys: "Ctrl+Shift+Z", run: () => Mn({ do: "redo" }), why: () => _() ?? (za.value.redo === null ? "There is nothing to redo." : null) },
  { id: "save", group: "Work", label: "Save a version with a name", keys: "Ctrl+S", run: () => Je.value = "save", why: _ },
  { id: "picture", group: "Work", label: "Save the picture", keys: "Ctrl+Shift+S", run: () => Je.value = "picture" },
  { id: "command", group: "Work", label: "Copy the command that renders this picture", run: Fi },
  { id: "share", group: "Work", label: "Share by link", run: () => Je.value = "share" },
  { id: "false-colour", group: "Seeing", label: "False colour", keys: "B", run: Ii },
  {
    id: "quantity",
    group: "Seeing",
    label: "False colour of lux or of cd/m²",
    keys: "Shift+B",
    run: () => {
      let e = hi();
      Pi({ false_color: { ...ii(e), quantity: e.quantity === "illuminance" ? "luminance" : "illuminance" } });
    }
  },
  { id: "darker", group: "Seeing", label: "Darker by a third of a stop", keys: ",", run: () => _a(1) },
  { id: "brighter", group: "Seeing", label: "Brighter by a third of a stop", keys: ".", run: () => _a(-1) },
  { id: "expose", group: "Seeing", label: "Meter the exposure once", keys: "/", run: () => Li({ do: "expose" }) },
  { id: "before", group: "Seeing", label: "Before, as long as the key is held", keys: "hold \\", run: () => pi(!0) },
  { id: "wipe", group: "Seeing", label: "Wipe between before and now", keys: "C", run: Ai },
  { id: "meter", group: "Measure", label: "Meter under the pointer", keys: "P", why: _, run: () => et.peek() ? Ye(et.peek().point, et.peek().normal) : $e("meter") },
  { id: "meter-tool", group: "Measure", label: "Lay a meter by pointing", run: () => $e("meter"), why: _ },
  { id: "grid", group: "Measure", label: "Lay a grid by two corners", keys: "Shift+G", run: () => $e("grid"), why: _ },
  { id: "reach", group: "Measure", label: "Set the mix so that the targets are reached", run: () => Mn({ do: "reach" }), why: _ },
  { id: "units", group: "Measure", label: "Lux or foot-candles", run: () => Ua.value = Ua.peek() === "lx" ? "fc" : "lx" },
  { id: "look-store", group: "Looks", label: "Store a look", keys: "Ctrl+Enter", run: Vi, why: _ },
  { id: "look-recall", group: "Looks", label: "Recall a look by its digit", keys: "J, then 1…9", run: () => Pt("Press J, then the digit of the look.") },
  { id: "panels", group: "Page", label: "Panels away", keys: "U", run: () => Qa.value = !Qa.peek() },
  { id: "listing", group: "Page", label: "Faders or sheet", run: () => ja.value = ja.peek() === "faders" ? "sheet" : "faders" },
  { id: "travel", group: "Page", label: "Faders by the square law or even", run: () => no.value = no.peek() === "square" ? "linear" : "square" },
  { id: "marks", group: "Page", label: "Marks of lamps in the view", run: () => Ya.value = !Ya.peek() },
  { id: "fine", group: "Page", label: "Full resolution of fine displays", run: () => Xa.value = !Xa.peek() },
  { id: "theme", group: "Page", label: "Light or dark", run: () => eo.value = eo.peek() === "dark" ? "light" : "dark" },
  { id: "lock", group: "Page", label: "Look-only lock", run: () => Za.value = !Za.peek() },
  ...["default", "blender", "maya", "trackpad"].map((e) => ({
    id: `hands-${e}`,
    group: "Page",
    label: `Navigate as: ${e}`,
    run: () => wi.value = e
  })),
  { id: "help", group: "Page", label: "All keys", keys: "?", run: () => Je.value = "help" },
  { id: "palette", group: "Page", label: "Command palette", keys: "Ctrl+K", run: () => Je.value = "palette" }
];
$i(Di);
function Vt() {
  return [...(Ci.value?.cameras ?? []).map((t, n) => ({ name: t.name || `Camera ${n + 1}`, camera: t })), ...Ri.all().map(([, t]) => ({ name: t.name ?? "View", camera: t }))];
}

// src/later/compare.tsx
import { before as Wi, comparing as Ki, digits as Bi, fitted as Ui, useEffect as _i, useRef as Xi, viewSize as zi, wipeAt as Ln } from "./desk.js";
import { Fragment as ji, jsx as Pn, jsxs as Zi } from "./desk.js";
function Yi() {
  let e = Ki.value, t = Wi.value, n = Xi(null);
  if (_i(() => {
    let i = n.current;
    !i || !t || (i.width = t.picture.width, i.height = t.picture.height, i.getContext("2d", { alpha: !1 })?.drawImage(t.picture, 0, 0));
  }, [t, e]), !e || !t) return null;
  let [a] = zi.value, o = Ln.value, l = Ui(t.picture.width, t.picture.height), r = Math.max(0, Math.min(1, (o * a - l.x) / (t.picture.width * l.scale))), s = (i) => {
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
  return Zi(ji, { children: [
    Pn(
      "canvas",
      {
        ref: n,
        class: "before",
        "aria-hidden": "true",
        style: { clipPath: e === "wipe" ? `inset(0 ${100 - 100 * r}% 0 0)` : "none" }
      }
    ),
    Pn("span", { class: "tag left", children: "before" }),
    e === "wipe" && Pn(
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
        "aria-valuetext": `${Bi(o * 100)} % before`,
        style: { left: `${100 * o}%` },
        onPointerDown: s,
        onPointerMove: s,
        onKeyDown: p
      }
    )
  ] });
}

// src/later/inspector.tsx
import { act as sl, deselect as ou, Icon as jn, penless as Zn, selection as lu, signal as ru } from "./desk.js";

// src/later/measure.tsx
import {
  add as os,
  deselect as vo,
  digits as Ce,
  dot as ls,
  edit as Ht,
  grids as rs,
  Icon as yo,
  length as Nt,
  luxText as Ne,
  maintenance as In,
  meters as is,
  scale as ss,
  selection as ko,
  up as fo
} from "./desk.js";

// src/later/figures.tsx
import { maintenance as io, status as Tn } from "./desk.js";

// src/later/verdict.ts
function ro(e, t) {
  let n = ({ value: o, error: l, least: r }) => {
    let s = t ? 0 : l ?? 1 / 0;
    return o - s >= r ? "met" : o + s < r ? "missed" : "open";
  }, a = e.map(n);
  return a.includes("missed") ? "missed" : a.includes("open") ? "open" : "met";
}

// src/later/figures.tsx
import { jsx as ho } from "./desk.js";
var so = () => Tn.value?.stage === "moving" || Tn.value?.stage === "loading", Qi = () => so() || Tn.value?.stage === "refining", uo = { meter: 0.02, grid: 0.05 };
function co(e, t, n) {
  return e == null || t == null || t > n * e || Qi();
}
var Et = ({ lux: e }) => co(e?.[0], e?.[1], uo.meter), It = ({ mean: e, error: t }) => co(e, t, uo.grid), po = (e, t) => so() ? "open" : ro(e, t === !0);
function At({ lux: e, target: t, done: n }) {
  if (!e || !t) return null;
  let a = io.value;
  return po([{ value: e[0] * a, error: e[1] == null ? null : e[1] * a, least: t }], n);
}
function Rt({ mean: e, error: t, uniformity: n, uniformity_error: a, target: o, done: l }) {
  if (!o || e == null || n == null) return null;
  let r = io.value;
  return po([
    { value: e * r, error: t == null ? null : t * r, least: o.lux },
    { value: n, error: a ?? null, least: o.uniformity }
  ], l);
}
var mo = {
  met: ["✓", "reaches its target"],
  missed: ["✗", "misses its target"],
  open: ["≈", "within its ± of the target: not decided yet"]
};
function Vn({ of: e }) {
  if (!e) return null;
  let [t, n] = mo[e];
  return ho("b", { class: e, role: "img", "aria-label": n, title: n, children: t });
}
function En({ of: e }) {
  if (!e) return null;
  let [t, n] = mo[e];
  return ho("p", { class: e, children: `${t} ${n[0].toUpperCase()}${n.slice(1)}` });
}

// src/later/parts.tsx
import { Field as go, Gesture as Ji, Range as es, stroke as ts, useRef as ns } from "./desk.js";
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
function T(e) {
  return qt("label", { class: "line", children: [
    se("span", { children: e.label }),
    se(go, { ...e, label: e.name ?? e.label })
  ] });
}
function as(e, t) {
  if (e !== null)
    return Number.isNaN(e) ? "–" : t === "length" ? e.toFixed(2) : void 0;
}
function J({ label: e, names: t, quantity: n, value: a, set: o, step: l, disabled: r }) {
  let s = t ?? ["X", "Y", "Z"];
  return qt("div", { class: "line", role: "group", "aria-label": e, children: [
    se("span", { children: e }),
    se("span", { class: "triple", children: s.map((p, i) => se(
      go,
      {
        label: `${e} ${p}`,
        quantity: n,
        value: a[i],
        text: as(a[i], n),
        step: l,
        disabled: r,
        set: (u) => o(i, u)
      },
      p
    )) })
  ] });
}
function Re({ label: e, name: t, value: n, text: a, patch: o, reset: l, notch: r, class: s, style: p, disabled: i }) {
  let u = ns(null), c = (d) => () => {
    u.current?.[d](), u.current = null;
  }, h = (d) => u.current ? u.current.set(o(d)) : ts(e + t, t, o(d));
  return se(
    es,
    {
      label: e,
      value: n,
      text: a,
      notch: r,
      class: s,
      gradient: p,
      disabled: i,
      begin: () => u.current = new Ji(t),
      on: h,
      end: c("end"),
      cancel: c("cancel"),
      reset: l === void 0 ? void 0 : () => h(l)
    }
  );
}
function qe({ value: e, label: t, set: n }) {
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
import { Fragment as An, jsx as S, jsxs as X } from "./desk.js";
var us = [["surface", "on the surface"], ["horizontal", "horizontal"], ["vertical", "vertical"], ["cylindrical", "cylindrical"], ["camera", "toward the camera"]];
function wo() {
  let e = ko.value?.ids[0], t = is.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This meter is gone." });
  let n = (a, o) => {
    let { lux: l, done: r, ...s } = { ...t, ...o };
    Ht(`${t.name}: ${a}`, { meters: { [e]: s } });
  };
  return X(An, { children: [
    S("header", { class: "panel-head", children: S(qe, { label: "Name of the meter", value: t.name, set: (a) => n("rename", { name: a }) }) }),
    S("p", { class: `crumbs ${Et(t) ? "unsettled" : "known"}`, children: t.lux?.[1] != null ? `${Ne(t.lux[0] * In.value)} ±${Ne(t.lux[1] * In.value, !1)}` : "measuring" }),
    S("div", { class: "scroll", children: X(A, { title: "Meter", children: [
      X("label", { class: "line", children: [
        S("span", { children: "Measures" }),
        S("select", { "aria-label": "Kind of the meter", value: t.kind, onChange: (a) => n("kind", { kind: a.currentTarget.value }), children: us.map(([a, o]) => S("option", { value: a, children: o }, a)) })
      ] }),
      S(J, { label: "Point", quantity: "length", step: 0.01, value: t.point, set: (a, o) => n("move", { point: ue(t.point, a, o) }) }),
      S(T, { label: "At least", quantity: "lux", step: 50, value: t.target ?? 0, set: (a) => n("target", { target: a(t.target ?? 0) || null }) }),
      S(En, { of: At(t) }),
      S(J, { label: "Faces", quantity: "number", step: 0.1, value: t.normal.map((a) => Math.round(a * 1e3) / 1e3), set: (a, o) => n("turn", { normal: ue(t.normal, a, o) }) }),
      X("button", { class: "plain full", onClick: () => {
        vo(), Ht(`Remove ${t.name}`, { meters: { [e]: null } });
      }, children: [
        S(yo, { name: "bin" }),
        "Remove"
      ] })
    ] }) })
  ] });
}
var bo = [["corridor", 100, 0.4], ["stairs", 150, 0.4], ["filing", 300, 0.4], ["writing, reading", 500, 0.6], ["drawing", 750, 0.7]];
function xo() {
  let e = ko.value?.ids[0], t = rs.get(e);
  if (!t) return S("p", { class: "quiet empty", children: "This grid is gone." });
  let n = In.value, a = (i, u) => {
    let { name: c, corner: h, u: d, v: y, normal: v, columns: E, rows: N, border: ee, target: ve } = { ...t, ...u };
    Ht(`${t.name}: ${i}`, { grids: { [e]: { name: c, corner: h, u: d, v: y, normal: v, columns: E, rows: N, border: ee, target: ve } } });
  }, o = (i, u = t.border) => {
    let [c, h] = fn([dt(Nt(t.u), u), dt(Nt(t.v), u)]);
    a(i, { columns: c, rows: h, border: u });
  }, l = ls(t.corner, fo.value) - mt(), r = (i, u, c) => X(An, { children: [
    S("dt", { children: i }),
    S("dd", { children: u == null ? "…" : c(u) })
  ] }), s = (i, u) => i == null ? "" : ` ±${u(i)}`, p = t.target ?? { lux: 500, uniformity: 0.6 };
  return X(An, { children: [
    S("header", { class: "panel-head", children: S(qe, { label: "Name of the grid", value: t.name, set: (i) => a("rename", { name: i }) }) }),
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
        r("Ē", t.mean, (i) => Ne(i * n) + s(t.error, (u) => Ne(u * n, !1))),
        r("E min", t.min, (i) => Ne(i * n)),
        r("E max", t.max, (i) => Ne(i * n)),
        r("U₀ = min / mean", t.uniformity, (i) => Ce(i, 2) + s(t.uniformity_error, (u) => Ce(u, 2))),
        r("U d = min / max", t.max ? (t.min ?? 0) / t.max : null, (i) => Ce(i, 2))
      ] }) }),
      X(A, { title: "Target", children: [
        S(En, { of: Rt(t) }),
        X("label", { class: "line", children: [
          S("span", { children: "Class" }),
          X("select", { "aria-label": "Class of the target", value: "", onChange: (i) => {
            let u = bo[Number(i.currentTarget.value)];
            a("target", { target: u ? { lux: u[1], uniformity: u[2] } : null });
          }, children: [
            S("option", { value: "", children: t.target ? "choose…" : "none" }),
            bo.map(([i, u, c], h) => X("option", { value: h, children: [
              i,
              ": ",
              u,
              " lx, U₀ ",
              c
            ] }, i)),
            S("option", { value: "-1", children: "no target" })
          ] })
        ] }),
        S(T, { label: "Ē at least", quantity: "lux", step: 50, value: p.lux, set: (i) => a("target", { target: { ...p, lux: i(p.lux) } }) }),
        S(T, { label: "U₀ at least", quantity: "share", step: 0.05, value: p.uniformity, set: (i) => a("target", { target: { ...p, uniformity: i(p.uniformity) } }) })
      ] }),
      X(A, { title: "Area", children: [
        S(J, { label: "Corner", quantity: "length", step: 0.01, value: t.corner, set: (i, u) => a("move", { corner: ue(t.corner, i, u) }) }),
        S(T, { label: "Height", name: "Height above the floor", quantity: "length", step: 0.01, value: l, set: (i) => a("height", { corner: os(t.corner, ss(fo.value, i(l) - l)) }) }),
        S(T, { label: "Border", quantity: "length", step: 0.05, value: t.border ?? 0, set: (i) => o("border", Math.max(0, i(t.border ?? 0))) }),
        S(T, { label: "Columns", quantity: "number", step: 1, value: t.columns, set: (i) => a("spacing", { columns: Math.max(1, Math.min(200, Math.round(i(t.columns)))) }) }),
        S(T, { label: "Rows", quantity: "number", step: 1, value: t.rows, set: (i) => a("spacing", { rows: Math.max(1, Math.min(200, Math.round(i(t.rows)))) }) }),
        S("button", { class: "plain full", title: "EN 12464-1: p = 0.2 · 5^log d", onClick: () => o("standard spacing"), children: "Spacing of the standard" }),
        X("button", { class: "plain full", onClick: () => {
          vo(), Ht(`Remove ${t.name}`, { grids: { [e]: null } });
        }, children: [
          S(yo, { name: "bin" }),
          "Remove"
        ] })
      ] })
    ] })
  ] });
}

// src/later/lamp.tsx
import {
  act as ae,
  chosenLamps as Ms,
  dot as Fn,
  edit as Ot,
  format as Ao,
  groups as Dt,
  handles as Ft,
  Icon as Fe,
  lamps as Dn,
  layers as Ss,
  lumensOf as $s,
  normal as Ro,
  output as Cs,
  percent as On,
  positionOf as Lo,
  selection as qo,
  signal as No,
  spot as Ls,
  sub as Po,
  titleOf as Wn,
  tool as Ho,
  toLevel as To,
  toTravel as Ps,
  typeLevel as Gn,
  up as Ts,
  Fade as Vs,
  Field as Es,
  wantLevel as Vo,
  compass as Fo,
  add as Wt,
  scale as Ge,
  length as Is,
  Range as As,
  strokeLevel as Eo,
  typeGroupLevel as Rs,
  useRef as qs
} from "./desk.js";

// src/later/color.tsx
import {
  chosenLamps as ms,
  digits as So,
  edit as hs,
  fromHex as gs,
  hex as fs,
  lamps as $o,
  mired as Le,
  titleOf as bs
} from "./desk.js";

// src/later/white.ts
import { css as cs, mired as Rn } from "./desk.js";
function ps(e, t) {
  let [n, a] = [e / Math.max(t, 1e-6), (1 - e - t) / Math.max(t, 1e-6)];
  return [
    3.2404542 * n - 1.5371385 - 0.4985314 * a,
    -0.969266 * n + 1.8760108 + 0.041556 * a,
    0.0556434 * n - 0.2040259 + 1.0572252 * a
  ].map((l) => Math.max(0, l));
}
function ds(e) {
  let t = 1e3 / Math.max(1667, Math.min(25e3, e)), n = e <= 4e3 ? -0.2661239 * t ** 3 - 0.234358 * t ** 2 + 0.8776956 * t + 0.17991 : -3.0258469 * t ** 3 + 2.1070379 * t ** 2 + 0.2226347 * t + 0.24039, a = e <= 2222 ? -1.1063814 * n ** 3 - 1.3481102 * n ** 2 + 2.18555832 * n - 0.20219683 : e <= 4e3 ? -0.9549476 * n ** 3 - 1.37418593 * n ** 2 + 2.09137015 * n - 0.16748867 : 3.081758 * n ** 3 - 5.8733867 * n ** 2 + 3.75112997 * n - 0.37001483;
  return [n, a];
}
function Mo(e, t, n = 9) {
  return `linear-gradient(to right, ${Array.from({ length: n }, (o, l) => {
    let r = Rn(e) + (Rn(t) - Rn(e)) * l / (n - 1);
    return cs(ps(...ds(1e6 / r)));
  }).join(", ")})`;
}

// src/later/color.tsx
import { Fragment as Nn, jsx as G, jsxs as he } from "./desk.js";
var tt = 1800, Hn = 1e4, vs = [[2200, "candle"], [2700, "warm"], [3e3, "warm white"], [4e3, "neutral"], [5e3, "cool"], [6500, "daylight"]], ys = [["file", "File"], ["kelvin", "White"], ["rgb", "RGB"], ["xy", "x y"]], ks = Mo(tt, Hn), qn = (e, t) => ({
  lamps: Object.fromEntries(e.map((n) => [n, { color: t($o.get(n).color) }]))
}), ws = (e) => {
  let t = 1e6 / (Le(tt) + (Le(Hn) - Le(tt)) * e);
  return Math.round(t / 10) * 10;
}, xs = (e) => (Le(e) - Le(tt)) / (Le(Hn) - Le(tt));
function Co() {
  let e = ms.value, t = e.map((r) => $o.get(r)?.color).filter((r) => r !== void 0);
  if (!t.length) return null;
  let n = K(t.map((r) => r.mode)), a = t[0], o = bs(e), l = (r, s) => hs(`${o}: ${r}`, qn(e, s));
  return he(Nn, { children: [
    he("div", { class: "line", children: [
      G("span", { children: "Colour" }),
      G("div", { class: "segments", role: "group", "aria-label": "Colour by", children: ys.map(([r, s]) => G("button", { "aria-pressed": n === r, onClick: () => l(`colour by ${s}`, () => ({ mode: r })), children: s }, r)) })
    ] }),
    n === "kelvin" && he(Nn, { children: [
      he("div", { class: "line slide", children: [
        G("span", { children: "White" }),
        G(
          Re,
          {
            label: "Colour temperature",
            name: `${o}: white`,
            class: "mired",
            style: ks,
            value: xs(a.kelvin),
            text: `${So(a.kelvin)} kelvin`,
            patch: (r) => qn(e, () => ({ mode: "kelvin", kelvin: ws(r) }))
          }
        )
      ] }),
      G(
        T,
        {
          label: "",
          name: "Colour temperature, typed",
          quantity: "kelvin",
          value: K(t.map((r) => r.kelvin)),
          step: 50,
          set: (r) => l("white", (s) => ({ mode: "kelvin", kelvin: r(s.kelvin) }))
        }
      ),
      G("div", { class: "whites", role: "group", "aria-label": "Whites", children: vs.map(([r, s]) => G("button", { title: s, "aria-label": `${r} kelvin, ${s}`, onClick: () => l(`${r} K`, () => ({ mode: "kelvin", kelvin: r })), children: r }, r)) }),
      he("div", { class: "line slide", children: [
        G("span", { title: "Duv × 1000: below magenta, above green", children: "Tint" }),
        G(
          Re,
          {
            label: "Tint, magenta to green",
            name: `${o}: tint`,
            class: "tints",
            value: (a.tint + 20) / 40,
            text: `${So(a.tint, 1)} thousandths`,
            notch: 0.025,
            reset: 0.5,
            patch: (r) => qn(e, () => ({ tint: Math.round((r * 40 - 20) * 2) / 2 }))
          }
        )
      ] }),
      G(T, { label: "", name: "Tint, typed", quantity: "number", value: K(t.map((r) => r.tint)), step: 1, set: (r) => l("tint", (s) => ({ tint: Math.max(-50, Math.min(50, r(s.tint))) })) })
    ] }),
    n === "rgb" && he(Nn, { children: [
      he("label", { class: "line", children: [
        G("span", { children: "Colour" }),
        G("input", { type: "color", class: "pick", "aria-label": "Colour", value: fs(a.rgb), onChange: (r) => l("colour", () => ({ mode: "rgb", rgb: gs(r.currentTarget.value) })) })
      ] }),
      G(
        J,
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
        T,
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
import { Fragment as Kn, jsx as b, jsxs as O } from "./desk.js";
var He = No(1), Gt = No([1, 0, 0]), Ns = [[-1, "−1"], [-1 / 3, "−⅓"], [1 / 3, "+⅓"], [1, "+1"]], Kt = 180 / Math.PI;
function Io(e, t) {
  let { right: n, ahead: a } = Fo(t), o = -Fn(e, t);
  return [Math.atan2(Fn(e, n), Fn(e, a)) * Kt, Math.asin(Math.max(-1, Math.min(1, o))) * Kt];
}
function Hs(e, t, n) {
  let { right: a, ahead: o } = Fo(n), [l, r] = [e / Kt, t / Kt], s = Wt(Ge(a, Math.sin(l)), Ge(o, Math.cos(l)));
  return Ro(Wt(Ge(s, Math.cos(r)), Ge(n, -Math.sin(r))));
}
function Fs({ ids: e, all: t }) {
  let n = t.some((o) => o.place?.direction), a = qo.value?.kind === "group";
  return O("div", { class: "tools", role: "toolbar", "aria-label": "Lamps", children: [
    O("button", { "aria-pressed": Ho.value === "aim", "aria-disabled": !n, title: "Aim by pointing (T): then click what shall be lit", onClick: () => ae("aim"), children: [
      b(Fe, { name: "aim" }),
      "Aim"
    ] }),
    b("button", { class: "icon", "aria-label": "Solo", title: "Solo (I)", onClick: () => ae("solo"), children: b(Fe, { name: "solo" }) }),
    b("button", { class: "icon", "aria-label": "View from the lamp", title: "View from the lamp (Shift+L)", "aria-disabled": !n, onClick: () => ae("from-lamp"), children: b(Fe, { name: "eye" }) }),
    b("button", { class: "icon", "aria-label": "Frame", title: "Frame (F)", onClick: () => ae("frame"), children: b(Fe, { name: "frame" }) }),
    b("span", { class: "gap" }),
    xt() === null && b("button", { title: "Group (Ctrl+G): one master for all of them", onClick: () => ae("group"), children: "Group" }),
    Mt() === null && b("button", { title: a ? "Dissolve the group (Ctrl+Shift+G): its lamps stay" : "Take out of the group (Ctrl+Shift+G)", onClick: () => ae("ungroup"), children: a ? "Dissolve" : "Take out" }),
    b("button", { title: "Off, and not traced (Shift+O)", "aria-pressed": t.every((o) => o.parked), onClick: () => ae("park"), children: "Park" }),
    b("button", { class: "icon", "aria-label": `Remove ${Wn(e)}`, title: "Remove (Del)", onClick: () => ae("remove"), children: b(Fe, { name: "bin" }) })
  ] });
}
function Gs({ ids: e, all: t }) {
  let n = K(t.map((r) => r.level)), a = $s(e), o = t.every((r) => r.free), l = e[e.length - 1];
  return O(A, { title: "Light", note: o ? "re-mix" : "re-trace", children: [
    O("div", { class: "line slide", children: [
      b("span", { children: "Level" }),
      b(Os, { id: l })
    ] }),
    O("label", { class: "line", children: [
      b("span", {}),
      b(
        Es,
        {
          label: "Level of the selection",
          quantity: "level",
          value: n,
          flux: K(t.map((r) => r.flux)) ?? void 0,
          step: 0.01,
          set: (r) => Gn(e, r),
          open: Vo.value,
          opened: () => Vo.value = "",
          id: "level"
        }
      )
    ] }),
    b(
      T,
      {
        label: "Flux",
        quantity: "flux",
        value: e.length === 1 ? t[0].flux * t[0].level : null,
        set: (r) => Gn(e, (s, p) => r(s * p) / p)
      }
    ),
    O("div", { class: "line", children: [
      b("span", { children: "Stops" }),
      b("div", { class: "steps", role: "group", "aria-label": "Level by stops", children: Ns.map(([r, s]) => b("button", { "aria-label": `${s} stop`, onClick: () => Gn(e, (p) => Math.min(1e3, p * 2 ** r)), children: s }, s)) })
    ] }),
    O("p", { class: "sum", children: [
      Ao(a, "flux"),
      " now",
      e.length > 1 ? `, all ${e.length} together` : "",
      t.length === 1 && t[0].group !== null && (Dt.get(t[0].group)?.level ?? 1) !== 1 && ` (${On(t[0].level)} % × ${On(Dt.get(t[0].group)?.level ?? 1)} % of the group)`
    ] }),
    b(Co, {})
  ] });
}
function Os({ id: e }) {
  let t = qs(null), n = Dn.get(e);
  if (!n) return null;
  let a = { kind: "lamp", id: e }, o = (l) => () => {
    t.current?.[l](), t.current = null;
  };
  return b(
    As,
    {
      label: "Level",
      value: Ps(n.level),
      text: `${On(n.level)} %, ${Ao(n.flux * Cs(n), "flux")}`,
      begin: () => t.current = new Vs(a),
      on: (l) => t.current ? t.current.to(To(l)) : Eo(a, To(l)),
      end: o("end"),
      cancel: o("cancel"),
      reset: () => Eo(a, 1)
    }
  );
}
function nt(e, t, n) {
  let a = {};
  for (let o of e) {
    let l = Dn.get(o), r = n(l.place ?? {}, l);
    r && (a[o] = { place: r });
  }
  Object.keys(a).length && Ot(`${Wn(e)}: ${t}`, { lamps: a });
}
function Ds({ ids: e, all: t }) {
  let n = (o) => K(t.map((l) => l.place?.[o] ?? null)), a = (o) => t.some((l) => l.place?.[o] != null);
  return !a("outer") && !a("radius") ? null : O(A, { title: "Beam", note: "re-trace", children: [
    a("outer") && O(Kn, { children: [
      b(T, { label: "Full to", quantity: "angle", step: 1, value: n("inner"), set: (o) => nt(e, "beam", (l) => l.outer == null ? null : { inner: Math.max(0.1, Math.min(l.outer, o(l.inner ?? l.outer))) }) }),
      b(T, { label: "Ends at", quantity: "angle", step: 1, value: n("outer"), set: (o) => nt(e, "beam", (l) => {
        if (l.outer == null) return null;
        let r = Math.max(0.2, Math.min(179, o(l.outer)));
        return { outer: r, inner: Math.min(l.inner ?? r, r) };
      }) })
    ] }),
    a("radius") && b(T, { label: "Radius", quantity: "length", step: 0.01, value: n("radius"), set: (o) => nt(e, "radius", (l) => l.radius == null ? null : { radius: Math.max(1e-3, o(l.radius)) }) })
  ] });
}
function Ws({ ids: e, all: t }) {
  let n = t.filter((c) => Lo(c) !== null);
  if (!n.length) return null;
  let a = n.map((c) => Lo(c)), o = (c, h) => K(h.map((d) => Math.round(d[c] * 1e4) / 1e4)), l = t.filter((c) => c.place?.direction), r = Ts.value, s = l.map((c) => Io(c.place?.direction, r).map((h) => Math.round(h * 10) / 10)), p = t.map((c) => c.place?.aim).filter((c) => !!c), i = (c, h) => {
    let d = Ze(e), y = {};
    for (let [v, E] of d) {
      let N = [0, 0, 0];
      N[c] = h(E[c]) - E[c], Object.assign(y, je([v], N, d).lamps);
    }
    Ot(`Move ${Wn(e)}`, { lamps: y });
  }, u = (c, h) => nt(e, c ? "tilt" : "pan", (d) => {
    if (!d.direction) return null;
    let y = Io(d.direction, r);
    y[c] = h(y[c]);
    let v = Hs(y[0], Math.max(-90, Math.min(90, y[1])), r), E = d.aim && d.position ? Is(Po(d.aim, d.position)) : 0;
    return { direction: v, ...E && d.position ? { aim: Wt(d.position, Ge(v, E)) } : {} };
  });
  return O(A, { title: "Place", note: "re-trace", children: [
    b(J, { label: "Position", quantity: "length", step: 0.01, value: [0, 1, 2].map((c) => o(c, a)), set: i }),
    l.length > 0 && O(Kn, { children: [
      b(T, { label: "Pan", quantity: "angle", step: 1, value: K(s.map((c) => c[0])), set: (c) => u(0, c) }),
      b(T, { label: "Tilt", quantity: "angle", step: 1, value: K(s.map((c) => c[1])), set: (c) => u(1, c) }),
      b(
        J,
        {
          label: "Aims at",
          quantity: "length",
          step: 0.01,
          value: p.length ? [0, 1, 2].map((c) => o(c, p)) : [NaN, NaN, NaN],
          set: (c, h) => nt(e, "aim", (d) => {
            if (!d.direction || !d.position) return null;
            let y = ue(d.aim ?? Wt(d.position, Ge(d.direction, 2)), c, h);
            return { aim: y, direction: Ro(Po(y, d.position)) };
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
    b("button", { class: "plain full", "aria-pressed": Ho.value === "place", onClick: () => ae("place"), children: "Put on a surface by pointing" }),
    l.length > 0 && Ls.value && b("button", { class: "plain full", onClick: () => ae("aim-here"), children: "Aim at the last point" })
  ] });
}
function Ks({ ids: e, all: t }) {
  return t.some((n) => n.kind === "surface" || n.kind === "sky") ? null : O(A, { title: "Copies along a line", children: [
    b(T, { label: "How many", quantity: "number", step: 1, value: He.value, set: (n) => He.value = Math.max(1, Math.min(100, Math.round(n(He.value)))) }),
    b(J, { label: "Step", quantity: "length", step: 0.05, value: Gt.value, set: (n, a) => Gt.value = ue(Gt.value, n, a) }),
    O("button", { class: "plain full", onClick: () => yt(e, He.value, Gt.value), children: [
      b(Fe, { name: "copy" }),
      He.value === 1 ? "One copy" : `${He.value} copies`
    ] })
  ] });
}
function Go() {
  let e = Ms.value, t = e.map((s) => Dn.get(s)).filter((s) => !!s);
  if (!t.length) return b("p", { class: "quiet empty", children: "This lamp is gone." });
  let n = t.length === 1 ? t[0] : null, a = n && Dt.get(n.group), o = qo.value, l = o?.kind === "group" && o.ids.length === 1 ? Dt.get(o.ids[0]) : void 0, r = n?.layer != null ? Ss.value[n.layer] : void 0;
  return O(Kn, { children: [
    b("header", { class: "panel-head", children: l && o ? b(qe, { label: "Name of the group", value: l.name, set: (s) => Ot(`Rename ${l.name}`, { groups: { [o.ids[0]]: { name: s } } }) }) : n ? b(qe, { label: "Name of the lamp", value: n.name, set: (s) => Ot(`Rename ${n.name}`, { lamps: { [e[0]]: { name: s } } }) }) : O("h2", { children: [
      t.length,
      " lamps"
    ] }) }),
    b("p", { class: "crumbs", children: n ? `${n.kind}${a && a.lamps.length > 1 ? ` ▸ ${a.name}` : ""}${r ? ` ▸ ${r.name}` : ""}` : `${t.filter((s) => s.on).length} of ${t.length} on` }),
    O("div", { class: "scroll", children: [
      b(Fs, { ids: e, all: t }),
      l && o && b(A, { title: "Group", note: "re-mix", children: b(T, { label: "Master", name: "Master of the group", quantity: "level", step: 0.01, value: l.level, set: (s) => Rs(o.ids[0], s) }) }),
      b(Gs, { ids: e, all: t }),
      b(A, { title: "Photometry", children: b("button", { class: "plain full", disabled: !0, title: "Photometric files (IES, LDT) come with a later version", children: "IES or LDT file… comes later" }) }),
      b(Ds, { ids: e, all: t }),
      b(Ws, { ids: e, all: t }),
      b(Ks, { ids: e, all: t }),
      b("p", { class: "cost", children: t.every((s) => s.free) ? "Level and colour are a re-mix: no ray. Place and beam are traced anew." : "Some of these share no layer of their own: their level is traced anew." })
    ] })
  ] });
}

// src/later/scene.tsx
import {
  act as Bn,
  candles as Bt,
  command as Bs,
  digits as _t,
  edit as Oo,
  Field as Do,
  filterOf as Uo,
  go as Us,
  history as _s,
  hovered as Wo,
  Icon as Xt,
  layers as Xs,
  lookOnly as Ko,
  maintenance as Oe,
  materials as zs,
  percent as Ys,
  scene as js,
  select as _o,
  signal as Zs,
  singleKeys as Bo,
  sub as Qs,
  things as Js,
  travel as Ut,
  Virtual as Xo,
  workPlane as Un
} from "./desk.js";
import { Fragment as eu, jsx as x, jsxs as V } from "./desk.js";
function zo() {
  let e = js.value;
  if (!e) return null;
  let t = Qs(e.bounds[1], e.bounds[0]);
  return V(eu, { children: [
    V(A, { title: "Room", children: [
      V("p", { children: [
        t.map((n) => _t(n, 2)).join(" × "),
        " m",
        e.triangles ? `, ${_t(e.triangles)} triangles` : ""
      ] }),
      x("p", { class: "path", children: e.file }),
      e.cameras.length > 0 && x("ul", { class: "buttons", children: e.cameras.map((n, a) => x("li", { children: x("button", { onClick: () => Us(n, n.name ?? "camera"), children: n.name || `Camera ${a + 1}` }) }, a)) }),
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
        x(Do, { label: "Maintenance factor", quantity: "share", value: Oe.value, step: 0.05, set: (n) => Oe.value = Math.max(0.1, Math.min(1, n(Oe.value))) })
      ] }),
      V("p", { class: "quiet", children: [
        Oe.value === 1 ? "New installation: figures as they are." : "Every figure is multiplied by this.",
        Oe.value === 1 && x("button", { class: "plain", onClick: () => Oe.value = 0.8, children: "0.80" })
      ] }),
      V("label", { class: "line", children: [
        x("span", { children: "Work plane" }),
        x(Do, { label: "Work plane above the floor", quantity: "length", value: Un.value, step: 0.05, set: (n) => Un.value = Math.max(0, Math.min(3, n(Un.value))) })
      ] }),
      V("div", { class: "line", children: [
        x("span", { children: "Unit" }),
        V("div", { class: "segments", role: "group", "aria-label": "Unit of illuminance", children: [
          x("button", { "aria-pressed": Bt.value === "lx", onClick: () => Bt.value = "lx", children: "lx, cd/m²" }),
          x("button", { "aria-pressed": Bt.value === "fc", onClick: () => Bt.value = "fc", children: "fc, fL" })
        ] })
      ] })
    ] }),
    x(A, { title: "Layers of light", children: x("ul", { class: "layers", children: Xs.value.map((n, a) => V("li", { class: n.batches < n.of && !n.held ? "busy" : "", children: [
      x("i", { class: "dot", "aria-hidden": "true" }),
      x("span", { children: n.name || `layer ${a + 1}` }),
      x("small", { children: n.held ? "held" : Ys(n.of ? n.batches / n.of : 0) + " %" })
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
        x("input", { type: "checkbox", checked: Bo.value, onChange: (n) => Bo.value = n.currentTarget.checked }),
        "Keys of one letter"
      ] }),
      V("label", { class: "check", children: [
        x("input", { type: "checkbox", checked: Ko.value, onChange: (n) => Ko.value = n.currentTarget.checked }),
        "Look only"
      ] })
    ] })
  ] });
}
var zt = Zs("");
function Yo({ label: e }) {
  return x("span", { class: "field filter", children: x("input", { type: "text", "aria-label": e, placeholder: "Filter", value: zt.value, onInput: (t) => zt.value = t.currentTarget.value }) });
}
function jo() {
  let e = Uo(Js, zt.value);
  return V("div", { class: "listing", children: [
    x(Yo, { label: "Filter things" }),
    x(
      Xo,
      {
        label: "Things",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return V("div", { class: "sheet-row thing", role: "listitem", onPointerEnter: () => Wo.value = { kind: "thing", id: n }, onPointerLeave: () => Wo.value = null, children: [
            x("button", { class: "icon", "aria-pressed": !a.hidden, "aria-label": `${a.name} shown`, onClick: () => Oo(`${a.hidden ? "Show" : "Hide"} ${a.name}`, { things: { [n]: { hidden: !a.hidden } } }), children: x(Xt, { name: a.hidden ? "eye-off" : "eye" }) }),
            x("button", { class: "row-name", onClick: () => _o("thing", n), children: x("span", { children: a.name }) }),
            x("button", { class: "icon", "aria-pressed": a.locked, "aria-label": `${a.name} locked`, onClick: () => Oo(`${a.locked ? "Unlock" : "Lock"} ${a.name}`, { things: { [n]: { locked: !a.locked } } }), children: x(Xt, { name: a.locked ? "lock" : "unlock" }) })
          ] }, n);
        }
      }
    )
  ] });
}
function Zo() {
  let e = Uo(zs, zt.value);
  return V("div", { class: "listing", children: [
    x(Yo, { label: "Filter materials" }),
    x(
      Xo,
      {
        label: "Materials",
        count: e.length,
        height: 28,
        row: (t) => {
          let [n, a] = e[t];
          return V("div", { class: "sheet-row material", role: "listitem", children: [
            x("button", { class: "row-name", onClick: () => _o("material", n), children: x("span", { children: a.name }) }),
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
function Qo() {
  let e = _s.value;
  return V(A, { title: "History", children: [
    V("p", { children: [
      e.steps === 1 ? "One step" : `${_t(e.steps)} steps`,
      " so far; all can be undone."
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.undo === null, onClick: () => Bn("undo"), children: [
      x(Xt, { name: "undo" }),
      e.undo ? `Undo: ${e.undo}` : "Nothing to undo"
    ] }),
    V("button", { class: "plain full", "aria-disabled": e.redo === null, onClick: () => Bn("redo"), children: [
      x(Xt, { name: "redo" }),
      e.redo ? `Redo: ${e.redo}` : "Nothing to redo"
    ] }),
    x("button", { class: "plain full", onClick: () => Bn("save"), children: "Save a version with a name…" }),
    x("button", { class: "plain full", onClick: () => Bs({ do: "save" }), children: "Save now" })
  ] });
}

// src/later/thing.tsx
import {
  digits as _n,
  edit as nl,
  fromHex as tu,
  hex as nu,
  Icon as Jo,
  materials as al,
  middle as el,
  select as ol,
  selection as ll,
  things as Xn
} from "./desk.js";
import { Fragment as Yn, jsx as L, jsxs as Y } from "./desk.js";
var zn = 180 / Math.PI;
function tl(e, t) {
  return e ? 2 * Math.atan2(e[t], e[3]) * zn : 0;
}
function au(e, t) {
  let n = [0, 0, 0, Math.cos(t / zn / 2)];
  return n[e] = Math.sin(t / zn / 2), n;
}
function rl() {
  let e = (ll.value?.ids ?? []).filter((p) => Xn.get(p)), t = e.map((p) => Xn.get(p));
  if (!t.length) return L("p", { class: "quiet empty", children: "This thing is gone." });
  let n = t[0], a = e.length === 1 ? n.name : `${e.length} things`, o = t.some((p) => p.locked), l = (p, i) => nl(`${a}: ${p}`, { things: Object.fromEntries(e.map((u, c) => [u, i(t[c])])) }), r = t.map((p) => p.place?.position ?? (p.box ? el(p.box) : [0, 0, 0])), s = n.box ? [0, 1, 2].map((p) => n.box[1][p] - n.box[0][p]) : null;
  return Y(Yn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: a }) }),
    s && Y("p", { class: "crumbs", children: [
      s.map((p) => _n(p, 2)).join(" × "),
      " m"
    ] }),
    Y("div", { class: "scroll", children: [
      Y("div", { class: "tools", role: "toolbar", "aria-label": "Thing", children: [
        Y("button", { "aria-pressed": t.every((p) => p.hidden), onClick: () => l(n.hidden ? "show" : "hide", () => ({ hidden: !n.hidden })), children: [
          L(Jo, { name: n.hidden ? "eye-off" : "eye" }),
          n.hidden ? "Hidden" : "Hide"
        ] }),
        Y("button", { "aria-pressed": o, onClick: () => l(o ? "unlock" : "lock", () => ({ locked: !o })), children: [
          L(Jo, { name: o ? "lock" : "unlock" }),
          o ? "Locked" : "Lock"
        ] })
      ] }),
      Y(A, { title: "Place", note: "re-trace", children: [
        o && L("p", { class: "quiet", children: "Locked, as all that the file brings. Unlock it to move it." }),
        L(
          J,
          {
            label: "Position",
            quantity: "length",
            step: 0.01,
            disabled: o,
            value: [0, 1, 2].map((p) => K(r.map((i) => Math.round(i[p] * 1e4) / 1e4))),
            set: (p, i) => l("move", (u) => ({ place: { position: ue(u.place?.position ?? el(u.box), p, i) } }))
          }
        ),
        [0, 1, 2].map((p) => L(
          T,
          {
            label: `Turn ${"XYZ"[p]}`,
            quantity: "angle",
            step: 5,
            disabled: o,
            value: K(t.map((i) => Math.round(tl(i.place?.rotation, p) * 10) / 10)),
            set: (i) => l("turn", (u) => ({ place: { rotation: au(p, i(tl(u.place?.rotation, p))) } }))
          },
          p
        )),
        L(
          T,
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
      L(A, { title: "Materials", children: L("ul", { class: "buttons", children: n.materials.map((p) => L("li", { children: L("button", { onClick: () => ol("material", p), children: al.get(p)?.name ?? `material ${p}` }) }, p)) }) })
    ] })
  ] });
}
function il() {
  let e = ll.value?.ids[0], t = al.get(e);
  if (!t) return L("p", { class: "quiet empty", children: "This material is gone." });
  let n = (i, u) => nl(`${t.name}: ${i}`, { materials: { [e]: u } }), a = t.transmittance ? "transmittance" : "color", o = t.transmittance ?? t.color ?? [0.5, 0.5, 0.5], r = ((i) => 0.2126 * i[0] + 0.7152 * i[1] + 0.0722 * i[2])(o), s = (i) => o.map((u) => Math.max(0, Math.min(1, r > 1e-4 ? u / r * i : i))), p = (i, u) => t[u] != null && Y(Yn, { children: [
    Y("div", { class: "line slide", children: [
      L("span", { children: i }),
      L(Re, { label: i, name: `${t.name}: ${i.toLowerCase()}`, value: t[u], text: _n(t[u], 2), patch: (c) => ({ materials: { [e]: { [u]: Math.round(c * 1e3) / 1e3 } } }) })
    ] }),
    L(T, { label: "", name: `${i}, typed`, quantity: "share", step: 0.01, value: t[u], set: (c) => n(i.toLowerCase(), { [u]: Math.max(0, Math.min(1, c(t[u]))) }) })
  ] });
  return Y(Yn, { children: [
    L("header", { class: "panel-head", children: L("h2", { children: t.name }) }),
    L("p", { class: "crumbs", children: t.kind }),
    Y("div", { class: "scroll", children: [
      Y(A, { title: t.transmittance ? "What passes" : "What is sent back", note: "re-trace", children: [
        Y("div", { class: "line slide", children: [
          L("span", { children: t.transmittance ? "Transmittance" : "Reflectance" }),
          L(Re, { label: t.transmittance ? "Transmittance" : "Reflectance", name: `${t.name}: ${t.transmittance ? "transmittance" : "reflectance"}`, value: r, text: _n(r, 2), patch: (i) => ({ materials: { [e]: { [a]: s(Math.min(0.95, i)) } } }) })
        ] }),
        L(T, { label: "", name: "Reflectance, typed", quantity: "share", step: 0.01, value: Math.round(r * 1e3) / 1e3, set: (i) => n("reflectance", { [a]: s(Math.min(0.98, i(r))) }) }),
        Y("label", { class: "line", children: [
          L("span", { children: "Colour" }),
          L("input", { type: "color", class: "pick", "aria-label": "Colour", value: nu(o), onChange: (i) => n("colour", { [a]: tu(i.currentTarget.value) }) })
        ] }),
        p("Roughness", "roughness"),
        p("Gloss", "specular")
      ] }),
      L(A, { title: "On", children: L("ul", { class: "buttons", children: Xn.all().filter(([, i]) => i.materials.includes(e)).slice(0, 40).map(([i, u]) => L("li", { children: L("button", { onClick: () => ol("thing", i), children: u.name }) }, i)) }) })
    ] })
  ] });
}

// src/later/inspector.tsx
import { Fragment as ul, jsx as H, jsxs as Yt } from "./desk.js";
var at = ["Scene", "Things", "Materials", "History"], ge = ru("Scene");
function iu() {
  let e = { Scene: zo, Things: jo, Materials: Zo, History: Qo }[ge.value];
  return Yt(ul, { children: [
    H("div", { class: "tabs", role: "tablist", "aria-label": "Nothing is selected", onKeyDown: (n) => {
      let a = { ArrowRight: 1, ArrowLeft: -1 }[n.key];
      a && (n.preventDefault(), n.stopPropagation(), ge.value = at[(at.indexOf(ge.value) + a + at.length) % at.length], document.getElementById(`tab-${ge.value}`)?.focus());
    }, children: at.map((n) => H("button", { id: `tab-${n}`, role: "tab", "aria-selected": ge.value === n, "aria-controls": "tab-panel", tabIndex: ge.value === n ? 0 : -1, onClick: () => ge.value = n, children: n }, n)) }),
    H("div", { class: "scroll", id: "tab-panel", role: "tabpanel", "aria-labelledby": `tab-${ge.value}`, tabIndex: 0, children: H(e, {}) })
  ] });
}
function su() {
  let e = lu.value;
  return e ? Yt(ul, { children: [
    Yt("nav", { class: "chooser", "aria-label": "Selection", children: [
      H("button", { class: "icon", "aria-label": "Previous", title: "Previous ([)", onClick: () => sl("previous"), children: H(jn, { name: "back" }) }),
      H("button", { class: "icon", "aria-label": "Next", title: "Next (])", onClick: () => sl("next"), children: H(jn, { name: "forth" }) }),
      H("span", { class: "quiet", children: e.ids.length > 1 ? `${e.ids.length} ${e.kind}s` : e.kind }),
      H("span", { class: "gap" }),
      H("button", { class: "icon", "aria-label": "Select nothing", title: "Select nothing (Esc)", onClick: ou, children: H(jn, { name: "close" }) })
    ] }),
    Zn.value && H("p", { class: "penless", children: Zn.value }),
    Yt("fieldset", { class: "editing", disabled: Zn.value !== null, children: [
      (e.kind === "lamp" || e.kind === "group") && H(Go, {}),
      e.kind === "thing" && H(rl, {}),
      e.kind === "material" && H(il, {}),
      e.kind === "meter" && H(wo, {}),
      e.kind === "grid" && H(xo, {})
    ] })
  ] }) : H(iu, {});
}

// src/later/legend.tsx
import { asked as uu, candles as cu, display as pu, Field as du, show as mu, three as hu, useRef as gu } from "./desk.js";
import { jsx as j, jsxs as jt } from "./desk.js";
var Qn = [1, 2, 5];
function fu(e, t, n) {
  let a = [];
  if (n === "linear") {
    let o = (t - e) / 5, l = 10 ** Math.floor(Math.log10(o)), r = l * (Qn.find((s) => s * l >= o) ?? 10);
    for (let s = Math.ceil(e / r) * r; s <= t * 1.0001; s += r) a.push(s);
    return a;
  }
  for (let o = Math.floor(Math.log10(e)); o <= Math.ceil(Math.log10(t)); o++)
    for (let l of Qn) {
      let r = l * 10 ** o;
      r >= e * 0.999 && r <= t * 1.001 && a.push(r);
    }
  return a.length > 10 ? a.filter((o) => Math.abs(Math.log10(o) % 1) < 1e-6) : a;
}
function bu(e, t) {
  return t.scale === "linear" ? (e - t.low) / (t.high - t.low) : Math.log(e / t.low) / Math.log(t.high / t.low);
}
var ce = (e, t) => {
  let n = uu({ ...e, ...t });
  n.scale === "log" && (n.low = Math.max(n.low, 1e-3)), n.high > n.low * 1.01 && mu({ false_color: n });
};
function cl(e, t) {
  let n = Math.round(Math.log10(e) * 3) + t, a = (n % 3 + 3) % 3;
  return Qn[a] * 10 ** ((n - a) / 3);
}
function vu() {
  let e = pu.value.false_color, t = gu(null);
  if (!e) return null;
  let n = cu.value === "fc", a = e.quantity === "illuminance", o = a ? n ? "fc" : "lx" : n ? "fL" : "cd/m²", l = n ? a ? 1 / 10.7639 : 0.2919 : 1, r = e.colors?.length ? `linear-gradient(to top, ${e.colors.join(", ")})` : void 0, s = e.ticks ?? fu(e.low, e.high, e.scale).map((u) => [u, bu(u, e)]), p = (u) => ({
    onPointerDown: (c) => {
      c.currentTarget.setPointerCapture(c.pointerId), t.current = { y: c.clientY, end: u, from: e[u] };
    },
    onPointerMove: (c) => {
      let h = t.current;
      h?.end === u && ce(e, { [u]: cl(h.from, Math.round((h.y - c.clientY) / 14)) });
    },
    onPointerUp: () => t.current = null,
    onPointerCancel: () => t.current = null,
    onKeyDown: (c) => {
      let h = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1 }[c.key];
      h && (c.preventDefault(), c.stopPropagation(), ce(e, { [u]: cl(e[u], h) }));
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
        "aria-valuetext": `${hu(e[u] * l)} ${o}`,
        ...p(u)
      }
    ),
    j(
      du,
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
  allActions as ta,
  act as bl,
  ask as Tu,
  command as Vu,
  copyText as Eu,
  digits as Iu,
  go as Au,
  hear as Ru,
  lamps as qu,
  say as en,
  select as Nu,
  send as Qt,
  sheet as lt,
  shown as Hu,
  signal as rt,
  useEffect as na,
  useLayoutEffect as Fu,
  useRef as tn,
  walkNames as Gu,
  whyNotTo as Ou
} from "./desk.js";

// src/later/csv.ts
import { gridPoint as yu, grids as ku, maintenance as wu, meters as xu, scene as pl } from "./desk.js";
var Mu = (e) => {
  let t = e == null ? "" : String(e);
  return /[",\n]/.test(t) ? `"${t.replace(/"/g, '""')}"` : t;
};
function Su() {
  let e = wu.peek(), t = [["scene", pl.peek()?.name ?? ""], ["maintenance factor", e], []];
  t.push(["meter", "kind", "x [m]", "y [m]", "z [m]", "lux", "± (95 %)"]);
  for (let [, n] of xu.all())
    t.push([n.name, n.kind, ...n.point, n.lux && n.lux[0] * e, n.lux && n.lux[1] * e]);
  for (let [, n] of ku.all()) {
    t.push([], ["grid", n.name], ["points", n.columns * n.rows]);
    let a = { mean: n.mean, min: n.min, max: n.max };
    for (let [o, l] of Object.entries(a)) t.push([o, l == null ? null : l * e]);
    t.push(["uniformity", n.uniformity], ["x [m]", "y [m]", "z [m]", "lux"]), (n.lux ?? []).forEach((o, l) => {
      let r = yu(n, l % n.columns, Math.floor(l / n.columns));
      t.push([...r.map((s) => s.toFixed(3)), o === null ? null : o * e]);
    });
  }
  return t.map((n) => n.map(Mu).join(",")).join(`\r
`) + `\r
`;
}
function Jn(e, t) {
  let n = document.createElement("a");
  n.href = t, n.download = e, document.body.append(n), n.click(), n.remove();
}
function dl() {
  let e = URL.createObjectURL(new Blob([Su()], { type: "text/csv" }));
  Jn(`${pl.peek()?.name ?? "figures"}.csv`, e), setTimeout(() => URL.revokeObjectURL(e), 1e4);
}

// src/later/qr.ts
var gl = [[19, 7, 1], [34, 10, 1], [55, 15, 1], [80, 20, 1], [108, 26, 1], [136, 18, 2]], Zt = new Uint8Array(512), ea = new Uint8Array(256);
for (let e = 0, t = 1; e < 255; e++)
  Zt[e] = Zt[e + 255] = t, ea[t] = e, t = t << 1 ^ (t & 128 ? 285 : 0);
var ml = (e, t) => e && t ? Zt[ea[e] + ea[t]] : 0;
function $u(e, t) {
  let n = [1];
  for (let o = 0; o < t; o++) {
    let l = new Array(n.length + 1).fill(0);
    n.forEach((r, s) => {
      l[s] ^= r, l[s + 1] ^= ml(r, Zt[o]);
    }), n = l;
  }
  let a = [...e, ...new Array(t).fill(0)];
  for (let o = 0; o < e.length; o++) {
    let l = a[o];
    l && n.forEach((r, s) => a[o + s] ^= ml(r, l));
  }
  return a.slice(e.length);
}
function Cu(e, t) {
  let [n, a, o] = gl[t - 1], l = [], r = (h, d) => {
    for (let y = d - 1; y >= 0; y--) l.push(h >> y & 1);
  };
  for (r(4, 4), r(e.length, 8), e.forEach((h) => r(h, 8)), r(0, Math.min(4, n * 8 - l.length)); l.length % 8; ) l.push(0);
  let s = [];
  for (let h = 0; h < l.length; h += 8) s.push(parseInt(l.slice(h, h + 8).join(""), 2));
  for (let h = 236; s.length < n; h ^= 253) s.push(h);
  let p = n / o, i = Array.from({ length: o }, (h, d) => s.slice(d * p, (d + 1) * p)), u = i.map((h) => $u(h, a)), c = (h) => h[0].flatMap((d, y) => h.map((v) => v[y]));
  return [...c(i), ...c(u)];
}
var Lu = [
  (e, t) => (e + t) % 2 === 0,
  (e, t) => t % 2 === 0,
  (e) => e % 3 === 0,
  (e, t) => (e + t) % 3 === 0,
  (e, t) => (Math.floor(t / 2) + Math.floor(e / 3)) % 2 === 0,
  (e, t) => e * t % 2 + e * t % 3 === 0,
  (e, t) => (e * t % 2 + e * t % 3) % 2 === 0,
  (e, t) => ((e + t) % 2 + e * t % 3) % 2 === 0
];
function Pu(e) {
  let t = 8 | e, n = t << 10;
  for (let a = 14; a >= 10; a--) n >> a & 1 && (n ^= 1335 << a - 10);
  return (t << 10 | n) ^ 21522;
}
function hl(e) {
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
function fl(e) {
  let t = [...new TextEncoder().encode(e)], n = gl.findIndex(([d]) => t.length + 2 <= d) + 1;
  if (!n) return null;
  let a = 17 + 4 * n, o = Array.from({ length: a }, () => new Array(a).fill(!1)), l = Array.from({ length: a }, () => new Array(a).fill(!1)), r = (d, y, v) => {
    d < 0 || y < 0 || d >= a || y >= a || (o[y][d] = v, l[y][d] = !0);
  };
  for (let d = 0; d < a; d++)
    r(d, 6, d % 2 === 0), r(6, d, d % 2 === 0);
  for (let [d, y] of [[3, 3], [a - 4, 3], [3, a - 4]])
    for (let v = -4; v <= 4; v++)
      for (let E = -4; E <= 4; E++) {
        let N = Math.max(Math.abs(E), Math.abs(v));
        r(d + E, y + v, N !== 2 && N !== 4);
      }
  if (n > 1) {
    let d = a - 7;
    for (let y = -2; y <= 2; y++) for (let v = -2; v <= 2; v++) r(d + v, d + y, Math.max(Math.abs(v), Math.abs(y)) !== 1);
  }
  let s = (d) => {
    let y = Pu(d);
    for (let v = 0; v < 15; v++) {
      let E = (y >> v & 1) === 1, N = v < 6 ? v : v < 8 ? v + 1 : a - 15 + v;
      r(8, N, E), r(v < 8 ? a - 1 - v : v < 9 ? 7 : 14 - v, 8, E);
    }
    r(8, a - 8, !0);
  };
  s(0);
  let p = Cu(t, n), i = 0;
  for (let d = a - 1; d > 0; d -= 2) {
    d === 6 && (d = 5);
    for (let y = 0; y < a; y++)
      for (let v of [d, d - 1]) {
        let N = (d + 1 & 2) === 0 ? a - 1 - y : y;
        l[N][v] || (o[N][v] = i < p.length * 8 && (p[i >> 3] >> 7 - (i & 7) & 1) === 1, i++);
      }
  }
  let u = (d) => (s(d), o.map((y, v) => y.map((E, N) => E !== (!l[v][N] && Lu[d](N, v))))), c = u(0), h = hl(c);
  for (let d = 1; d < 8; d++) {
    let y = u(d), v = hl(y);
    v < h && ([c, h] = [y, v]);
  }
  return c;
}

// src/later/sheets.tsx
import { Fragment as ju, jsx as g, jsxs as P } from "./desk.js";
function it({ title: e, wide: t, children: n }) {
  let a = tn(null);
  Fu(() => {
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
      children: P("div", { class: "sheet-body", children: [
        P("header", { children: [
          g("h2", { children: e }),
          g("span", { class: "gap" }),
          g("button", { onClick: o, children: "Close" })
        ] }),
        n
      ] })
    }
  );
}
var Du = [
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
function Wu() {
  let e = [...new Set(ta().map((t) => t.group))];
  return g(it, { title: "All keys", wide: !0, children: P("div", { class: "help", children: [
    P("table", { children: [
      g("caption", { class: "spoken", children: "By hand" }),
      g("thead", { children: P("tr", { children: [
        g("th", { scope: "col", children: "What" }),
        g("th", { scope: "col", children: "Mouse" }),
        g("th", { scope: "col", children: "Keys, in the view" }),
        g("th", { scope: "col", children: "Fingers" })
      ] }) }),
      g("tbody", { children: Du.map(([t, n, a, o]) => P("tr", { children: [
        g("th", { scope: "row", children: t }),
        g("td", { children: n }),
        g("td", { children: a.replace("walking keys", Gu.value) }),
        g("td", { children: o })
      ] }, t)) })
    ] }),
    P("div", { class: "columns", children: [
      e.map((t) => P("section", { children: [
        g("h3", { children: t }),
        g("dl", { children: ta().filter((n) => n.group === t && n.keys).map((n) => P(ju, { children: [
          g("dt", { children: n.label }),
          g("dd", { children: g("kbd", { children: n.keys }) })
        ] })) })
      ] }, t)),
      P("section", { children: [
        g("h3", { children: "Numbers" }),
        P("dl", { children: [
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
function Ku() {
  let e = Jt.value.toLowerCase().split(/\s+/).filter(Boolean), t = (a) => e.every((o) => a.toLowerCase().includes(o)), n = ta().filter((a) => t(`${a.group} ${a.label}`)).map((a) => ({ label: a.label, note: a.keys ?? a.group, why: Ou(a.id), run: () => bl(a.id) }));
  for (let { name: a, camera: o } of Vt())
    t(`view ${a}`) && n.push({ label: `View: ${a}`, note: "view", why: null, run: () => Au(o, a) });
  if (e.length)
    for (let [a, o] of qu.all()) {
      if (n.length > 60) break;
      t(o.name) && n.push({ label: o.name, note: "lamp", why: null, run: () => Nu("lamp", a) });
    }
  return n.slice(0, 60);
}
function Bu() {
  let e = Ku(), t = Math.min(ot.value, e.length - 1);
  na(() => {
    Jt.value = "", ot.value = 0;
  }, []), na(() => {
    document.getElementById(`command-${t}`)?.scrollIntoView({ block: "nearest" });
  }, [t]);
  let n = (a) => {
    a && (lt.value = null, a.why ? en(a.why, "warn") : setTimeout(a.run, 0));
  };
  return P(it, { title: "Command palette", children: [
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
    P("ul", { class: "commands", id: "commands", role: "listbox", "aria-label": "Commands", children: [
      e.map((a, o) => P(
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
var vl = rt([]);
Ru("links", (e) => vl.value = e.links);
function Uu({ text: e }) {
  let t = fl(e);
  if (!t) return null;
  let n = t.length + 8, a = t.map((o, l) => o.map((r, s) => r ? `M${s + 4} ${l + 4}h1v1h-1z` : "").join("")).join("");
  return P("svg", { class: "qr", viewBox: `0 0 ${n} ${n}`, role: "img", "aria-label": `Code of ${e}`, children: [
    g("rect", { width: n, height: n, fill: "#fff" }),
    g("path", { d: a, fill: "#000" })
  ] });
}
function _u() {
  let e = rt(null), t = tn(e).current;
  return na(() => {
    Qt({ do: "links", what: "list" });
  }, []), P(it, { title: "Share by link", children: [
    g("p", { class: "quiet", children: "Who has a link may do what it says until it is revoked. One edits at a time; whoever takes the pen leaves the other's work as it is." }),
    g("ul", { class: "links", children: vl.value.map((n) => P("li", { children: [
      g("strong", { children: n.role === "edit" ? "Edits" : "Watches" }),
      g("code", { children: n.address }),
      P("span", { class: "buttons", children: [
        g("button", { onClick: () => {
          Eu(n.address);
        }, children: "Copy" }),
        g("button", { "aria-expanded": t.value === n.id, onClick: () => t.value = t.value === n.id ? null : n.id, children: "Code" }),
        g("button", { onClick: () => Qt({ do: "links", what: "revoke", id: n.id }), children: "Revoke" })
      ] }),
      t.value === n.id && g(Uu, { text: n.address })
    ] }, n.id)) }),
    P("footer", { children: [
      g("button", { onClick: () => Qt({ do: "links", what: "make", role: "watch" }), children: "New link to watch" }),
      g("button", { onClick: () => Qt({ do: "links", what: "make", role: "edit" }), children: "New link to edit" })
    ] })
  ] });
}
function Xu() {
  let e = tn(null), t = () => {
    let n = e.current?.value.trim();
    if (!n) return e.current?.focus();
    Vu({ do: "save", name: n }), lt.value = null, en(`Saving the version “${n}”.`);
  };
  return P(it, { title: "Save a version", children: [
    g("p", { class: "quiet", children: "Every edit is saved by itself. A version with a name is kept beside." }),
    P("label", { class: "line", children: [
      g("span", { children: "Name" }),
      g("span", { class: "field", children: g("input", { ref: e, type: "text", autofocus: !0, maxLength: 120, onKeyDown: (n) => n.key === "Enter" && t() }) })
    ] }),
    g("footer", { children: g("button", { onClick: t, children: "Save" }) })
  ] });
}
var te = rt(null);
function zu() {
  let e = Hu.value?.head, t = tn(null), n = (o) => t.current?.querySelector(`[name=${o}]`)?.value ?? "", a = () => {
    te.value = 0;
    let [o, l] = [Number(n("width")), Number(n("height"))];
    Tu("picture", { format: n("format"), width: o, height: l, batches: Number(n("batches")) }, (r) => {
      r.why ? (te.value = null, en(r.why, "warn")) : r.url ? (te.value = null, Jn(r.name, r.url), lt.value = null) : te.value = r.progress ?? 0;
    }, (r) => {
      te.value = null, en(r, "warn");
    });
  };
  return P(it, { title: "Save the picture", children: [
    P("div", { ref: t, class: "form", children: [
      P("label", { class: "line", children: [
        g("span", { children: "Format" }),
        P("select", { name: "format", children: [
          g("option", { value: "png", children: "PNG, as it is shown" }),
          g("option", { value: "exr", children: "EXR, the light itself" })
        ] })
      ] }),
      P("label", { class: "line", children: [
        g("span", { children: "Width" }),
        g("input", { type: "number", name: "width", min: 16, max: 16384, value: Math.max(e?.width ?? 0, 640) })
      ] }),
      P("label", { class: "line", children: [
        g("span", { children: "Height" }),
        g("input", { type: "number", name: "height", min: 16, max: 16384, value: Math.max(e?.height ?? 0, 480) })
      ] }),
      P("label", { class: "line", children: [
        g("span", { children: "Batches" }),
        g("input", { type: "number", name: "batches", min: 1, max: 1e5, value: 64 })
      ] })
    ] }),
    te.value !== null && g("progress", { max: 1, value: te.value, "aria-label": "Rendering" }),
    P("footer", { children: [
      g("button", { onClick: () => bl("command"), children: "Copy the command" }),
      g("button", { disabled: te.value !== null, onClick: a, children: te.value === null ? "Render and save" : te.value ? `${Iu(te.value * 100)} %` : "Rendering…" })
    ] })
  ] });
}
function Yu() {
  switch (lt.value) {
    case "help":
      return g(Wu, {});
    case "palette":
      return g(Bu, {});
    case "share":
      return g(_u, {});
    case "save":
      return g(Xu, {});
    case "picture":
      return g(zu, {});
    default:
      return null;
  }
}

// src/later/sheetrow.tsx
import {
  act as Zu,
  colorText as yl,
  cost as Qu,
  css as Ju,
  Field as ec,
  groups as tc,
  hovered as nn,
  Icon as nc,
  lamps as ac,
  lumensOf as oc,
  penless as lc,
  pickRow as rc,
  select as ic,
  selection as kl,
  switchOn as sc,
  three as uc,
  typeGroupLevel as cc,
  typeLevel as pc
} from "./desk.js";
import { jsx as Z, jsxs as aa } from "./desk.js";
function dc() {
  return aa("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    Z("span", {}),
    Z("span", { children: "Name" }),
    Z("span", { children: "Level" }),
    Z("span", { children: "lm" }),
    Z("span", { children: "White" })
  ] });
}
function mc({ row: e, index: t, count: n }) {
  let a = e.kind === "lamp" ? ac.get(e.id) : void 0, o = e.kind === "group" ? tc.get(e.id) : void 0, l = a ?? o;
  if (!l) return null;
  let r = kl.value?.kind === e.kind && kl.value.ids.includes(e.id), s = oc(o?.lamps ?? [e.id]), p = lc.value, i = nn.value?.kind === e.kind && nn.value.id === e.id;
  return aa(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${r ? "selected" : ""} ${l.on ? "" : "off"} ${i ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => nn.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => nn.value = null,
      children: [
        Z("button", { class: "icon power", "aria-pressed": l.on, disabled: p !== null, title: p ?? void 0, "aria-label": `${l.name} on`, onClick: () => sc(e, !l.on), children: Z(nc, { name: "power" }) }),
        Z("button", { class: "row-name", "aria-pressed": r, title: a ? Qu(a) : void 0, onClick: (u) => rc(u, e.kind, e.id), onDblClick: () => Zu("frame"), children: Z("span", { children: l.name }) }),
        Z(
          ec,
          {
            label: `${l.name} level`,
            quantity: "level",
            value: l.level,
            flux: a?.flux,
            step: 0.01,
            disabled: p !== null,
            why: p,
            set: (u) => a ? pc([e.id], u) : cc(e.id, u)
          }
        ),
        Z("span", { class: "lumens", children: uc(s) }),
        a ? aa("button", { class: "tint", "aria-label": `${l.name} colour: ${yl(a)}`, onClick: () => ic("lamp", e.id), children: [
          Z("i", { class: "swatch", style: { background: Ju(a.swatch) } }),
          yl(a)
        ] }) : Z("span", {})
      ]
    }
  );
}

// src/later/strip.tsx
import {
  act as oa,
  command as $l,
  digits as la,
  fade as an,
  Field as hc,
  grids as wl,
  Icon as De,
  looks as xl,
  luxText as fe,
  maintenance as gc,
  meters as Ml,
  select as Sl,
  selection as on,
  signal as fc,
  storeLook as bc
} from "./desk.js";
import { Fragment as xc, jsx as M, jsxs as F } from "./desk.js";
var ra = fc("looks");
function vc() {
  return F("section", { class: "looks", "aria-label": "Looks", children: [
    F("header", { children: [
      M("h2", { children: "Looks" }),
      M("button", { class: "tab", onClick: () => ra.value = "meters", children: "Meters" }),
      M("button", { class: "icon", "aria-label": "Store a look", title: "Store a look (Ctrl+Enter)", onClick: bc, children: M(De, { name: "plus" }) }),
      M("span", { class: "gap" }),
      F("label", { class: "tint", children: [
        "Fade",
        M(hc, { label: "Cross-fade", quantity: "seconds", value: an.value, step: 0.5, set: (e) => an.value = Math.max(0, e(an.value)) })
      ] })
    ] }),
    F("ul", { children: [
      xl.all().map(([e, t], n) => F("li", { class: "look", children: [
        F("button", { class: "recall", title: `${t.name}: recall (J ${n + 1})`, onClick: () => $l({ do: "look", id: e, what: "recall", seconds: an.peek() }), children: [
          t.picture && M("img", { src: t.picture, alt: "" }),
          M("span", { children: t.name })
        ] }),
        M(yc, { id: e, name: t.name })
      ] }, e)),
      !xl.ids.value.length && M("li", { class: "quiet", children: "Levels, colours, on and off, kept under a name: + stores what is set now." })
    ] })
  ] });
}
function yc({ id: e, name: t }) {
  let n = `look-${e}`, a = (s) => {
    let p = s.getBoundingClientRect(), i = document.getElementById(n);
    i?.style.setProperty("left", `${Math.min(p.left, innerWidth - 296)}px`), i?.style.setProperty("bottom", `${innerHeight - p.top + 4}px`), i?.style.setProperty("top", "auto");
  }, o = { popovertarget: n }, l = () => document.getElementById(n)?.hidePopover(), r = (s, p = {}) => {
    l(), $l({ do: "look", id: e, what: s, ...p });
  };
  return F(xc, { children: [
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
function kc() {
  let e = gc.value;
  return F("section", { class: "readings", "aria-label": "Meters and grids", children: [
    F("header", { children: [
      M("h2", { children: "Meters" }),
      M("button", { class: "tab", onClick: () => ra.value = "looks", children: "Looks" }),
      M("button", { class: "icon", "aria-label": "Lay a meter", title: "Lay a meter by pointing", onClick: () => oa("meter-tool"), children: M(De, { name: "meter" }) }),
      M("button", { class: "icon", "aria-label": "Lay a grid", title: "Lay a grid by two corners", onClick: () => oa("grid"), children: M(De, { name: "grid" }) }),
      M("button", { onClick: () => oa("reach"), title: "Set levels so that meters and areas come nearest to their targets", children: "Reach targets" }),
      M("button", { onClick: dl, title: "Save all figures as CSV", children: "CSV" }),
      M("span", { class: "gap" }),
      M("span", { class: "quiet", children: e === 1 ? "new installation" : `× ${la(e, 2)} maintained` })
    ] }),
    F("ul", { children: [
      Ml.all().map(([t, n]) => {
        let a = n.lux;
        return M("li", { children: F("button", { class: "reading", "aria-pressed": on.value?.kind === "meter" && on.value.ids.includes(t), onClick: () => Sl("meter", t), children: [
          F("span", { class: "tint", children: [
            M(De, { name: "meter" }),
            n.name,
            " ",
            M(Vn, { of: At(n) })
          ] }),
          M("strong", { class: Et(n) ? "unsettled" : "", children: a ? fe(a[0] * e) : "…" }),
          F("small", { children: [
            a?.[1] != null ? `±${fe(a[1] * e, !1)}` : "measuring",
            " ",
            n.kind,
            n.target ? ` · wants ${fe(n.target)}` : ""
          ] })
        ] }) }, `m${t}`);
      }),
      wl.all().map(([t, n]) => {
        let a = n.target;
        return M("li", { children: F("button", { class: "reading", "aria-pressed": on.value?.kind === "grid" && on.value.ids.includes(t), onClick: () => Sl("grid", t), children: [
          F("span", { class: "tint", children: [
            M(De, { name: "grid" }),
            n.name,
            " ",
            M(Vn, { of: Rt(n) })
          ] }),
          M("strong", { class: It(n) ? "unsettled" : "", children: n.mean == null ? "…" : `Ē ${fe(n.mean * e)}${n.error == null ? "" : ` ±${fe(n.error * e, !1)}`}` }),
          F("small", { children: [
            "U₀ ",
            n.uniformity == null ? "…" : la(n.uniformity, 2),
            " · ",
            n.min == null ? "…" : fe(n.min * e, !1),
            " to",
            " ",
            n.max == null ? "…" : fe(n.max * e, !1),
            a ? ` · wants ${fe(a.lux)}, U₀ ${la(a.uniformity, 2)}` : ""
          ] })
        ] }) }, `g${t}`);
      }),
      !Ml.ids.value.length && !wl.ids.value.length && M("li", { class: "quiet", children: "P lays a meter under the pointer." })
    ] })
  ] });
}
function wc() {
  return F("div", { class: "strip-parts", "data-tab": ra.value, children: [
    M(vc, {}),
    M(kc, {})
  ] });
}

// src/later/menus.tsx
import {
  camera as Pl,
  digits as Tl,
  display as Mc,
  Field as rn,
  go as Vl,
  houseLights as ia,
  Item as Pe,
  Range as Sc,
  show as sa,
  theme as Cl,
  walking as $c
} from "./desk.js";
import { Fragment as sn, jsx as $, jsxs as ne } from "./desk.js";
var ln = Math.PI / 360;
function Ll(e) {
  let t = Pl.peek();
  t && Vl({ ...t, fov: Math.max(3, Math.min(140, e)) });
}
function Cc() {
  let e = Pl.value, t = Vt();
  return ne(sn, { children: [
    ["home", "frame", "inside", "back", "forth", "store-view"].map((n) => $(Pe, { id: n }, n)),
    $("hr", {}),
    ["plan", "ceiling", "north", "east", "south", "west"].map((n) => $(Pe, { id: `preset-${n}` }, n)),
    $("hr", {}),
    t.length > 0 && $("p", { class: "quiet", children: "Cameras of the file and saved views" }),
    t.map(({ name: n, camera: a }, o) => $("button", { class: "item", onClick: () => Vl(a, n), children: $("span", { children: n }) }, o)),
    t.length > 0 && $("hr", {}),
    e && !e.height && ne(sn, { children: [
      ne("label", { class: "line", children: [
        $("span", { children: "Angle" }),
        $(rn, { label: "Vertical angle of view", quantity: "angle", value: e.fov, step: 1, set: (n) => Ll(n(e.fov)) })
      ] }),
      ne("label", { class: "line", children: [
        $("span", { children: "Focal length" }),
        $(rn, { label: "Focal length on 36 × 24 mm", quantity: "number", value: Math.round(120 / Math.tan(e.fov * ln)) / 10, text: `${Tl(12 / Math.tan(e.fov * ln), 1)} mm`, step: 1, set: (n) => Ll(Math.atan(12 / Math.max(2, n(12 / Math.tan(e.fov * ln)))) / ln) })
      ] }),
      $("hr", {})
    ] }),
    $(Pe, { id: "walking", label: $c.value === "walk" ? "Walking; fly instead" : "Flying; walk instead" }),
    $(Pe, { id: "from-lamp" }),
    ["default", "blender", "maya", "trackpad"].map((n) => $(Pe, { id: `hands-${n}` }, n))
  ] });
}
var Lc = ["linear", "reinhard", "filmic"];
function Pc() {
  let e = Mc.value, t = e.white ?? { kelvin: 6500, tint: 0 };
  return ne(sn, { children: [
    ne("fieldset", { children: [
      $("legend", { children: "Tone curve" }),
      $("div", { class: "segments", children: Lc.map((n) => $("button", { "aria-pressed": e.tone === n, onClick: () => sa({ tone: n }), children: n }, n)) })
    ] }),
    ne("fieldset", { children: [
      $("legend", { children: "White balance" }),
      ne("label", { class: "line", children: [
        $("span", { children: "White" }),
        $(rn, { label: "White", quantity: "kelvin", value: t.kelvin, step: 100, set: (n) => sa({ white: { ...t, kelvin: n(t.kelvin) } }) })
      ] }),
      ne("label", { class: "line", children: [
        $("span", { children: "Tint" }),
        $(rn, { label: "Tint of white", quantity: "number", value: t.tint, step: 1, set: (n) => sa({ white: { ...t, tint: n(t.tint) } }) })
      ] })
    ] }),
    $("hr", {}),
    ["expose", "darker", "brighter", "false-colour", "quantity", "units", "marks", "fine", "picture", "command"].map((n) => $(Pe, { id: n }, n))
  ] });
}
function Tc() {
  return ne(sn, { children: [
    ne("label", { class: "line", children: [
      $("span", { children: "House lights" }),
      $(Sc, { label: "House lights", value: ia.value, text: `${Tl(ia.value * 100)} %`, on: (e) => ia.value = Math.max(0.3, e) })
    ] }),
    $("div", { class: "segments", role: "group", "aria-label": "Theme", children: ["dark", "light", "system"].map((e) => $("button", { "aria-pressed": Cl.value === e, onClick: () => Cl.value = e, children: e }, e)) }),
    $("hr", {}),
    ["panels", "travel", "listing", "lock", "palette", "help", "save", "share"].map((e) => $(Pe, { id: e }, e))
  ] });
}

// src/later/views.tsx
import { act as un, cut as Vc, digits as El, edit as Il, go as Ec, Icon as st, Range as Ic, setCut as Ac, signal as Rc, storeView as qc, viewName as Nc, views as Hc } from "./desk.js";
import { jsx as W, jsxs as ua } from "./desk.js";
var cn = Rc(null);
function Fc() {
  let e = Hc.all();
  return ua("nav", { class: "view-strip", "aria-label": "Views", "data-scroll": !0, children: [
    W("button", { class: "icon", "aria-label": "Home", title: "Home", onClick: () => un("home"), children: W(st, { name: "home" }) }),
    W("button", { class: "icon", "aria-label": "Frame the selection", title: "Frame the selection (F)", onClick: () => un("frame"), children: W(st, { name: "frame" }) }),
    W("button", { class: "icon", "aria-label": "The view before", title: "The view before (Alt+←)", onClick: () => un("back"), children: W(st, { name: "back" }) }),
    W("button", { class: "icon", "aria-label": "The view after", title: "The view after (Alt+→)", onClick: () => un("forth"), children: W(st, { name: "forth" }) }),
    W("span", { class: "divide" }),
    e.map(([t, n], a) => cn.value === t ? W("span", { class: "field", children: W(
      "input",
      {
        type: "text",
        "aria-label": "Name of the view",
        value: n.name ?? "",
        maxLength: 60,
        ref: (o) => o?.focus(),
        onBlur: (o) => {
          let l = o.currentTarget.value.trim();
          cn.value = null, l && l !== n.name && Il(`Rename the view ${l}`, { views: { [t]: { ...n, name: l } } });
        },
        onKeyDown: (o) => {
          o.stopPropagation(), o.key === "Escape" && (o.currentTarget.value = n.name ?? ""), (o.key === "Enter" || o.key === "Escape") && o.currentTarget.blur();
        }
      }
    ) }, t) : ua(
      "button",
      {
        class: "saved-view",
        "aria-pressed": Nc.value === n.name,
        title: `${n.name ?? "View"} (Alt+${a + 1}); double click or F2 renames, Delete removes`,
        onClick: () => Ec(n, n.name ?? "view"),
        onDblClick: () => cn.value = t,
        onKeyDown: (o) => {
          o.key === "F2" && (cn.value = t), o.key === "Delete" && (o.stopPropagation(), Il(`Remove the view ${n.name ?? ""}`, { views: { [t]: null } }));
        },
        children: [
          W("small", { children: a + 1 }),
          " ",
          n.name ?? `View ${t + 1}`
        ]
      },
      t
    )),
    W("button", { class: "icon", "aria-label": "Store this view", title: "Store this view (Alt+0)", onClick: qc, children: W(st, { name: "plus" }) })
  ] });
}
function Gc() {
  let e = Vc.value;
  if (!e) return null;
  let t = e.height === null ? `${El(e.value, 2)} m` : `at ${El(e.height, 2)} m`;
  return ua("label", { class: "cut", "data-scroll": !0, children: [
    W("span", { children: "Cut" }),
    W(
      Ic,
      {
        label: "Cut, from the side of the eye",
        value: e.value / e.most,
        text: t,
        on: (n) => Ac(n * e.most)
      }
    ),
    W("output", { children: t })
  ] });
}

// src/later/walkpad.tsx
import { padWalk as Oc, useRef as Dc } from "./desk.js";
import { jsx as Al } from "./desk.js";
function Wc() {
  let e = Dc(null), t = (n) => {
    let a = n.currentTarget;
    n.stopPropagation(), n.type === "pointerdown" && a.setPointerCapture(n.pointerId);
    let o = n.type === "pointerup" || n.type === "pointercancel";
    if (!o && !a.hasPointerCapture(n.pointerId)) return;
    let l = a.getBoundingClientRect(), r = (i) => Math.max(-1, Math.min(1, i)), s = o ? 0 : r((n.clientX - l.left) / (l.width / 2) - 1), p = o ? 0 : r(1 - (n.clientY - l.top) / (l.height / 2));
    e.current?.style.setProperty("transform", `translate(${s * 28}px, ${-p * 28}px)`), Oc(p, s);
  };
  return Al("div", { class: "walkpad", "aria-hidden": "true", onPointerDown: t, onPointerMove: t, onPointerUp: t, onPointerCancel: t, children: Al("span", { ref: e }) });
}

// src/later/what.tsx
import {
  chosenLamps as Rl,
  closeWhat as ql,
  digits as Kc,
  hovered as Nl,
  Icon as Bc,
  lamps as Uc,
  luxText as be,
  nameOf as _c,
  select as Xc,
  useEffect as zc,
  useRef as Yc,
  viewSize as jc,
  what as Zc
} from "./desk.js";
import { jsx as B, jsxs as oe } from "./desk.js";
var Te = (e) => e.direct[0] + e.indirect[0] + e.caustic[0], Qc = (e) => Math.hypot(e.direct[1], e.indirect[1], e.caustic[1]);
function Jc() {
  let e = Zc.value, t = Yc(null);
  if (zc(() => {
    e && t.current && !t.current.contains(document.activeElement) && t.current.focus();
  }, [e?.x, e?.y]), !e) return null;
  let [n, a] = jc.value, o = [...e.lamps].sort((c, h) => Te(h) - Te(c)), l = o.reduce((c, h) => c + Te(h), 0) || 1, r = o.slice(0, 9), s = l - r.reduce((c, h) => c + Te(h), 0), p = Math.max(8, Math.min(e.x + 12, n - 332)), i = Math.max(8, Math.min(e.y + 12, a - 150 - 35 * r.length)), u = e.lux ? `${be(e.lux[0])} ±${be(e.lux[1], !1)}` : "Measuring…";
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
        c.key === "Escape" && (c.stopPropagation(), ql(), document.getElementById("view")?.focus());
      },
      "data-scroll": !0,
      children: [
        oe("header", { children: [
          B("strong", { class: e.done ? "" : "unsettled", children: u }),
          B("span", { class: "quiet", children: "what lights this" }),
          B("button", { class: "icon", "aria-label": "Close", onClick: ql, children: B(Bc, { name: "close" }) })
        ] }),
        oe("ol", { children: [
          r.map((c) => B(
            "li",
            {
              onPointerEnter: () => Nl.value = { kind: "lamp", id: c.id },
              onPointerLeave: () => Nl.value = null,
              children: oe("button", { class: "row", onClick: () => Xc("lamp", c.id), children: [
                B("span", { class: "name", children: _c("lamp", c.id) }),
                oe("span", { class: "figure", children: [
                  Kc(100 * Te(c) / l, Te(c) / l < 0.0995 ? 1 : 0),
                  " %"
                ] }),
                oe("span", { class: "figure lux", children: [
                  be(Te(c)),
                  " ±",
                  be(Qc(c), !1)
                ] }),
                oe("span", { class: "shares", "aria-hidden": "true", children: [
                  B("i", { class: "direct", style: { width: `${100 * c.direct[0] / l}%` } }),
                  B("i", { class: "indirect", style: { width: `${100 * c.indirect[0] / l}%` } }),
                  B("i", { class: "caustic", style: { width: `${100 * c.caustic[0] / l}%` } })
                ] }),
                oe("span", { class: "spoken", children: [
                  "direct ",
                  be(c.direct[0]),
                  ", indirect ",
                  be(c.indirect[0]),
                  ", caustic",
                  " ",
                  be(c.caustic[0])
                ] })
              ] })
            },
            c.id
          )),
          o.length > r.length && oe("li", { class: "quiet", children: [
            o.length - r.length === 1 ? "one more" : `${o.length - r.length} more together`,
            ": ",
            be(s)
          ] }),
          !o.length && B("li", { class: "quiet", children: e.done ? "No lamp reaches this point." : "Gathering light…" })
        ] }),
        oe("footer", { children: [
          B("span", { class: "key direct", children: "direct" }),
          B("span", { class: "key indirect", children: "indirect" }),
          B("span", { class: "key caustic", children: "caustic" }),
          B("span", { class: "gap" }),
          Rl.value.some((c) => Uc.get(c)?.place?.direction) && B("button", { onClick: () => Xe(Rl.peek(), e.hit.point), children: "Aim here" }),
          B("button", { onClick: () => Ye(e.hit.point, e.hit.normal), children: "Meter here" })
        ] })
      ]
    }
  );
}
export {
  Yi as Compare,
  Gc as CutBar,
  Or as Gizmo,
  su as Inspector,
  vu as Legend,
  Tc as PageItems,
  Pc as SeeingItems,
  dc as SheetHead,
  mc as SheetRow,
  Yu as Sheets,
  wc as Strip,
  oi as TypedHint,
  Cc as ViewItems,
  Fc as ViewStrip,
  Wc as WalkPad,
  Jc as What
};
