// node_modules/preact/dist/preact.mjs
var E, Jr, Mo, Fe, xo, Tn, Zr, Cn, ei, Co, So, ls, zt = /* @__PURE__ */ Symbol.for("pv"), Pn = {}, $n = [], us = /^m(i|n|o|s|text|space)$/, Eo = Array.isArray, To = $n.slice, et = Object.assign;
function Ze(e) {
  e && e.parentNode && e.remove();
}
function ti(e, t, n) {
  var o, r, i, a = {}, s = arguments.length;
  for (i in t) i == "key" ? o = t[i] : i == "ref" && typeof e != "function" ? r = t[i] : a[i] = t[i];
  return s > 2 && (a.children = s > 3 ? To.call(arguments, 2) : n), Bt(e, a, o, r, null);
}
function Bt(e, t, n, o, r) {
  var i = { type: e, props: t, key: n, ref: o, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: zt, __v: r || ++Jr, __i: -1, __u: 0 };
  return !r && E.vnode && E.vnode(i), i;
}
function X(e) {
  return e.children;
}
function gt(e, t) {
  this.props = e, this.context = t, this.__g = 0;
}
function Ne(e, t) {
  if (t == null) return e.__ && Ne(e.__, e.__i + 1);
  for (var n; t < e.__k.length; t++) if ((n = e.__k[t]) && n.__e) return n.__e;
  return typeof e.type != "function" || e.props.__P ? null : Ne(e);
}
function cs(e) {
  var t, n = e.__v, o = n.__e, r = [], i = [], a = e.__P;
  a && ((t = et({ constructor: zt }, n)).__v = n.__v + 1, E.vnode && E.vnode(t), Po(a, t, n, e.__n, a.namespaceURI, 32 & n.__u ? [o] : null, r, o || Ne(n), 32 & n.__u, i), t.__v = n.__v, t.__.__k[t.__i] = t, si(r, t, i), n.__ = n.__e = null, t.__e != o && ni(t));
}
function ni(e) {
  if ((e = e.__) && e.__c && !e.props.__P) return e.__e = null, e.__k.some(function(t) {
    return t && (e.__e = t.__e);
  }), ni(e);
}
function Yr(e) {
  (8 & e.__g || (e.__g |= 8, Fe.push(e), Tn++)) && xo == E.debounceRendering || ((xo = E.debounceRendering) || queueMicrotask)(oi);
}
function oi() {
  try {
    for (var e, t = 1; Fe.length; ) Fe.length > t && Fe.sort(Zr), e = Fe.shift(), t = Fe.length, 8 & e.__g && cs(e);
  } finally {
    (Tn = Fe.length) && (xo || queueMicrotask)(oi);
  }
}
function ri(e, t, n, o, r, i, a, s, p, c, u) {
  var d, m, f, b, y, w, x = o.__k || $n, k = t.length;
  for (p = fs(n, t, x, p, k), d = 0; d < k; d++) (f = n.__k[d]) != null && (m = ~f.__i && x[f.__i] || Pn, f.__i = d, w = Po(e, f, m, r, i, a, s, p, c, u), b = f.__e, (m.ref != f.ref || 8 & m.__u) && (m.ref && $o(m.ref, null, f, m), f.ref && u.push(f.ref, f.__c || b, f)), y = y || b, 4 & f.__u ? (p = ii(f, p, e, !m.__v), m.__e && (m.__e = null)) : typeof f.type == "function" && w !== void 0 ? p = w : b && (p = b.nextSibling), f.__u &= -21);
  return n.__e = y, p;
}
function fs(e, t, n, o, r) {
  var i, a, s, p, c, u, d, m, f, b = n.length, y = b, w = 0, x = 0, k = e.__k = Array(r);
  for (i = 0; i < r; i++) (a = t[i]) != null && typeof a != "boolean" && typeof a != "function" ? (typeof a != "object" || a.constructor === String ? a = k[i] = Bt(null, a) : Eo(a) ? a = k[i] = Bt(X, { children: a }) : a.constructor === zt && a.__b ? a = k[i] = Bt(a.type, a.props, a.key, a.ref, a.__v) : k[i] = a, p = i + w, a.__ = e, a.__b = e.__b + 1, s = null, ~(c = a.__i = ps(a, n, p, y)) && (y--, (s = n[c]) && (s.__u |= 2)), s && s.__v ? (a.__u |= 16, c == p - 1 ? w-- : c == p + 1 ? w++ : c != p && (c > p ? w-- : w++, x = 1)) : (~c || (r > b ? w-- : r < b && w++), typeof a.type != "function" && (a.__u |= 4))) : k[i] = null;
  if (x) {
    for (u = [], d = [], i = 0; i < r; i++) if ((a = k[i]) && 16 & a.__u) {
      for (w = 0, m = u.length; w < m; ) u[f = w + m >> 1] < a.__i ? w = f + 1 : m = f;
      u[w] = a.__i, d[i] = w + 1;
    }
    for (w = u.length; i--; ) d[i] && (d[i] == w ? w-- : k[i].__u |= 4);
  }
  if (y) for (i = 0; i < b; i++) !(s = n[i]) || 2 & s.__u || (s.__e == o && (o = Ne(s)), Lo(s, s));
  return o;
}
function ii(e, t, n, o) {
  var r, i, a, s;
  if (typeof e.type == "function") {
    if (e.props.__P) return t;
    if (r = e.__k) for (i = 0; i < r.length; i++) r[i] && (r[i].__ = e, t = ii(r[i], t, n, !1));
    return t;
  }
  for (t && !t.parentNode && (t = Ne(e)) && !t.parentNode && (t = null), a = e.__e, s = t; s && s.nodeType == 8; ) s = s.nextSibling;
  for (a != s && (!o && n.moveBefore && a.parentNode ? n.moveBefore(a, t) : n.insertBefore(a, t || null)), t = a; (t = t && t.nextSibling) && t.nodeType == 8 && !t.data.startsWith("$s"); ) ;
  return t;
}
function ps(e, t, n, o) {
  var r, i = e.key, a = e.type, s = t[n], p = s && !(2 & s.__u);
  if (s === null && i == null || p && i == s.key && a == s.type) return n;
  if (o > (p ? 1 : 0)) {
    for (r = n - 1; r >= 0; r--) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
    for (r = n + 1; r < t.length; r++) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
  }
  return -1;
}
function Qr(e, t, n) {
  n == null && (n = ""), t[0] == "-" ? e.setProperty(t, n) : e[t] = n;
}
function Mn(e, t, n, o, r) {
  var i, a;
  if (t == "style") if (typeof n == "string") e.style.cssText = n;
  else {
    if (typeof o == "string" && (e.style.cssText = o = ""), o) for (t in o) n && t in n || Qr(e.style, t);
    if (n) for (t in n) o && n[t] == o[t] || Qr(e.style, t, n[t]);
  }
  else if (t[0] == "o" && t[1] == "n") typeof n != "function" && (n = null), typeof o != "function" && (o = null), (e.__e || (e.__e = {}))[t] = n, n && o || (a = So[t] || (So[t] = ds(t)), (e.__a || (e.__a = {}))[t] = Co, i = t != (t = t.replace(ei, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), n ? e.addEventListener(t, a, i) : e.removeEventListener(t, a, i));
  else {
    if (r == "http://www.w3.org/2000/svg") t = t.replace(/xlink(H|:h)/, "h").replace(/sName$/, "s");
    else if (t != "width" && t != "height" && t != "href" && t != "list" && t != "form" && t != "tabIndex" && t != "download" && t != "rowSpan" && t != "colSpan" && t != "role" && t != "popover" && t in e) try {
      return void (e[t] = n ?? "");
    } catch {
    }
    if (typeof n == "function") return;
    n == null || n === !1 && t[4] != "-" ? e.removeAttribute(t) : e.setAttribute(t, t == "popover" && n == 1 ? "" : n);
  }
}
function ds(e) {
  return function(t) {
    var n = this.__e;
    if (n) {
      if (n = n[e], t[Cn] == null) t[Cn] = Co++;
      else if (t[Cn] < this.__a[e]) return;
      return n(E.event ? E.event(t) : t);
    }
  };
}
function Po(e, t, n, o, r, i, a, s, p, c) {
  var u, d, m, f, b, y, w, x, k, _, C, Me, Je, fe, ve, h, v, $, L = t.type;
  if (t.constructor !== zt) return null;
  128 & n.__u && (p = 32 & n.__u, u = n.__c.__z) && (t.__u |= p, d = i = [], u.nodeType == 8 ? s = En(u, i) : i.push(u), s = i[0] || s), (u = E.__b) && u(t);
  e: if (typeof L == "function") {
    m = a.length;
    try {
      if (x = t.props, k = (u = L.prototype) && u.render, _ = (u = L.contextType) && o[u.__c], C = u ? _ ? _.props.value : u.__ : o, (f = n.__c) ? (t.__c = f, 2 & f.__g && (f.__g |= 1)) : (k ? t.__c = f = new L(x, C) : (t.__c = f = new gt(x, C), f.constructor = L, f.render = hs), _ && _.sub(f), f.state || (f.state = {}), f.__n = o, f.__g |= 8, f.__h = [], f.__k = []), k && (f.__s || (f.__s = f.state), L.getDerivedStateFromProps && (f.__s == f.state && (f.__s = et({}, f.__s)), et(f.__s, L.getDerivedStateFromProps(x, f.__s)))), b = f.props, y = f.state, f.__v = t, n.__c) {
        if (x !== b && k && !L.getDerivedStateFromProps && f.componentWillReceiveProps && f.componentWillReceiveProps(x, C), t.__v == n.__v && !(8 & f.__g) || !(4 & f.__g) && f.shouldComponentUpdate && f.shouldComponentUpdate(x, f.__s, C) === !1) {
          t.__v != n.__v && (f.props = x, f.state = f.__s, f.__g &= -9), t.__e = n.__e, t.__k = n.__k, t.__k.some(function(V) {
            V && (V.__ = t);
          }), $n.push.apply(f.__h, f.__k), f.__k = [], f.__h.length && a.push(f), s = Ne(n);
          break e;
        }
        f.componentWillUpdate && f.componentWillUpdate(x, f.__s, C), k && f.componentDidUpdate && f.__h.push(function() {
          f.componentDidUpdate(b, y, w);
        });
      } else k && !L.getDerivedStateFromProps && f.componentWillMount && f.componentWillMount(), k && f.componentDidMount && f.__h.push(f.componentDidMount);
      f.context = C, f.props = x, f.__P = e, f.__g &= -5, Me = E.__r, Je = k ? 25 : 0;
      do
        f.__g &= -9, Me && Me(t), u = f.render(f.props, f.state = f.__s, f.context);
      while (8 & f.__g && ++Je < 25);
      k && ($n.push.apply(f.__h, f.__k), f.__k = []), f.state = f.__s, f.getChildContext && (o = et({}, o, f.getChildContext())), k && n.__c && f.getSnapshotBeforeUpdate && (w = f.getSnapshotBeforeUpdate(b, y)), fe = u && u.type === X && u.key == null ? u.props.children : u, x.__P && (u = s, r = (e = x.__P).namespaceURI, p = i = null, n.props && n.props.__P != e && (n.__k.some(function(V) {
        V && Lo(V, V);
      }), n.__k = null), s = n.__k ? Ne(n, 0) : null), s = ri(e, Eo(fe) ? fe : [fe], t, n, o, r, i, a, s, p, c), x.__P && (t.__e = null, s = u), t.__u &= -161, d && d.some(Ze), f.__h.length && a.push(f), 1 & f.__g && (f.__g &= -4);
    } catch (V) {
      if (a.length = m, t.__v = null, p || i) if (V && V.then) {
        if (t.__u |= 128 | p, i) {
          for (~(v = i.indexOf(s || void 0)) || (v = i.length); ($ = i[v - 1]) && $.nodeType == 8; ) v--;
          for (; v < i.length; v++) if ($ = i[v]) if (i[v] = null, ve) {
            if ($ == h) break;
          } else {
            if ($.nodeType != 8) break;
            $.data.startsWith("$s") && (h = En(ve = $));
          }
        }
        if (!ve) {
          for (; s && s.nodeType == 8 && s.nextSibling; ) s = s.nextSibling;
          ve = s;
        }
        (u = En(ve = t.__c.__z || (t.__c.__z = ve))) ? (t.__e = ve, s = u) : t.__e = s, s = s && s.nextSibling;
      } else i && i.some(Ze);
      else t.__e = n.__e;
      t.__k || (t.__k = n.__k || []), V && V.then || ai(t), E.__e(V, t, n);
    }
  } else s = t.__e = ms(n.__e, t, n, o, r, i, a, p, c, e);
  return (u = E.diffed) && u(t), s;
}
function En(e, t) {
  if (e && e.nodeType == 8 && e.data.startsWith("$s")) for (var n = 1; e = e.nextSibling; ) {
    if (e.nodeType == 8) {
      if (e.data.startsWith("$s")) n++;
      else if (e.data.startsWith("/$s") && !--n) return e;
    }
    t && t.push(e);
  }
}
function ai(e) {
  e && (e.__c && (e.__c.__g |= 4), e.__k && e.__k.some(ai));
}
function si(e, t, n) {
  for (var o = 0; o < n.length; ) $o(n[o++], n[o++], n[o++]);
  E.__c && E.__c(t, e), e.some(function(r) {
    try {
      e = r.__h, r.__h = [], e.some(function(i) {
        i.call(r);
      });
    } catch (i) {
      E.__e(i, r.__v);
    }
  });
}
function ms(e, t, n, o, r, i, a, s, p, c) {
  var u, d, m, f, b, y, w, x, k = n.props || Pn, _ = t.props, C = t.type;
  if (C == "svg" ? r = "http://www.w3.org/2000/svg" : C == "math" ? r = "http://www.w3.org/1998/Math/MathML" : r || (r = "http://www.w3.org/1999/xhtml"), i) {
    for (u = 0; u < i.length; u++) if ((b = i[u]) && (C ? b.localName == C : b.nodeType == 3)) {
      e = b, i[u] = null;
      break;
    }
  }
  if (!e) {
    if (x = c.ownerDocument || document, !C) return x.createTextNode(_);
    e = x.createElementNS(r, C, _.is ? _ : c), s && (E.__m && E.__m(t, i), s = !1), i = null;
  }
  if (C) {
    if (c = C == "template" && e.content || e, i = C == "textarea" && _.defaultValue != null ? null : i && To.call(c.childNodes), !s && i) for (k = {}, u = 0; u < e.attributes.length; u++) k[(b = e.attributes[u]).name] = b.value;
    for (u in k) b = k[u], u == "dangerouslySetInnerHTML" ? m = b : u == "children" || u in _ || u == "value" && "defaultValue" in _ || u == "checked" && "defaultChecked" in _ || Mn(e, u, null, b, r);
    for (u in _) b = _[u], u == "children" ? f = b : u == "dangerouslySetInnerHTML" ? d = b : u == "value" ? y = b : u == "checked" ? w = b : s && typeof b != "function" || k[u] === b || Mn(e, u, b, k[u], r);
    d ? (s || m && (d.__html == m.__html || d.__html == e.innerHTML) || (e.innerHTML = d.__html), t.__k = []) : (m && (e.textContent = ""), (C == "foreignObject" || r == "http://www.w3.org/1998/Math/MathML" && us.test(C)) && (r = "http://www.w3.org/1999/xhtml"), ri(c, Eo(f) ? f : [f], t, n, o, r, i, a, i ? i[0] : n.__k && Ne(n, 0), s, p), i && i.some(Ze)), s && C != "textarea" || (u = "value", C == "progress" && y == null ? e.removeAttribute(u) : y == null || y === e[u] && (C != "progress" || y) || Mn(e, u, y, k[u], r), u = "checked", w != null && w != e[u] && Mn(e, u, w, k[u], r));
  } else k === _ || s && e.data == _ || (e.data = _);
  return e;
}
function $o(e, t, n, o) {
  try {
    typeof e == "function" ? t ? t.__x = e(t) || 1 : o && (o = o.__c || o.__e) && (t = o.__x) && (o.__x = null, typeof t == "function" ? t() : e(null)) : e.current = t;
  } catch (r) {
    E.__e(r, n);
  }
}
function Lo(e, t, n) {
  var o, r, i, a;
  if (E.unmount && E.unmount(e), !(o = e.ref) || o.current && o.current != e.__e || $o(o, null, t, e), o = e.__c) {
    if (o.componentWillUnmount) try {
      o.componentWillUnmount();
    } catch (s) {
      E.__e(s, t);
    }
    o.__P = o.__n = null;
  }
  if (o = e.__k) for (a = 0; a < o.length; a++) o[a] && Lo(o[a], t, typeof e.type != "function" || n && !e.props.__P);
  !n && (o = e.__c) && (o = o.__z) && (r = En(o, i = [])) && (o == e.__e && i.some(Ze), Ze(r), Ze(o)), n || Ze(e.__e), e.__e = e.__c = e.__ = null;
}
function hs(e, t, n) {
  return this.constructor(e, n);
}
function li(e, t) {
  var n, o, r, i;
  E.__ && E.__(e, t), t.nodeType == 9 && (t = t.documentElement), o = (n = e && 32 & e.__u) ? null : t.__k, t.__k = Bt(X, { children: [e] }), r = [], i = [], Po(t, t.__k, o || Pn, Pn, t.namespaceURI, o ? null : t.firstChild ? To.call(t.childNodes) : null, r, o ? o.__e : t.firstChild, n, i), si(r, t.__k, i), t.__k.props.children = null;
}
E = { __e: function(e, t, n, o) {
  for (var r, i, a; t = t.__; ) if ((r = t.__c) && !(1 & r.__g)) {
    r.__g |= 4;
    try {
      if ((a = (i = r.constructor) && i.getDerivedStateFromError) && r.setState(i.getDerivedStateFromError(e)), r.componentDidCatch && (r.componentDidCatch(e, o || {}), a = 1), a && 8 & r.__g) return void (r.__g |= 2);
    } catch (s) {
      e = s;
    }
  }
  throw Tn = 0, e;
} }, Jr = 0, Mo = function(e) {
  return e != null && e.constructor === zt;
}, gt.prototype.setState = function(e, t) {
  var n = this.__s;
  n && n != this.state || (n = this.__s = et({}, this.state)), typeof e == "function" && (e = e(et({}, n), this.props)), e && (et(n, e), this.__v && (t && this.__k.push(t), Yr(this)));
}, gt.prototype.forceUpdate = function(e) {
  this.__v && (this.__g |= 4, e && this.__h.push(e), Yr(this));
}, gt.prototype.render = X, Fe = [], Tn = 0, Zr = function(e, t) {
  return e.__v.__b - t.__v.__b;
}, Cn = /* @__PURE__ */ Symbol(), ei = /(PointerCapture)$|Capture$/i, Co = 0, So = {}, ls = 0;

// node_modules/preact/hooks/dist/hooks.mjs
var Xt, re, Vo, ui, vs = Object.is, Io = 0, bi = [], Ao = [], j = E, ci = j.__b, fi = j.__r, pi = j.diffed, di = j.__c, mi = j.unmount, hi = j.__;
function Oo(e, t) {
  j.__h && j.__h(re, e, Io || t), Io = 0;
  var n = re.__H || (re.__H = { __: [], __h: [] });
  return e >= n.__.length && n.__.push({}), n.__[e];
}
function Ce(e, t) {
  var n = Oo(Xt++, 3);
  !j.__s && Ho(n.__H, t) && (n.__P = !0, n.__ = e, n.u = t, re.__H.__h.push(n));
}
function gs(e, t) {
  var n = Oo(Xt++, 4);
  !j.__s && Ho(n.__H, t) && (n.__P = !1, n.__ = e, n.u = t, re.__h.push(n));
}
function te(e) {
  return Io = 5, Ln(function() {
    return { current: e };
  }, []);
}
function Ln(e, t) {
  var n = Oo(Xt++, 7);
  return Ho(n.__H, t) && (n.__ = e(), n.__H = t), n.__;
}
function bs() {
  var e;
  do {
    for (; e = Ao.shift(); ) try {
      Gt(e);
    } catch (n) {
      j.__e(n, { __: (e = e.__P) && e.__v });
    }
    for (; e = bi.shift(); ) {
      var t = e.__H;
      if (e.__P && t) try {
        t.__h.some(Gt), t.__h.some(Ro), t.__h = [];
      } catch (n) {
        t.__h = [], j.__e(n, e.__v);
      }
    }
  } while (Ao.length);
}
j.__b = function(e) {
  re = null, ci && ci(e);
}, j.__ = function(e, t) {
  e && t.__k && t.__k.__m && (e.__m = t.__k.__m), hi && hi(e, t);
}, j.__r = function(e) {
  fi && fi(e), Xt = 0;
  var t = (re = e.__c).__H;
  t && (Vo == re ? re.__h = [] : (t.__h.some(Gt), t.__h.some(Ro), Xt = 0), t.__h = [], t.__.some(function(n) {
    n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
  })), Vo = re;
}, j.diffed = function(e) {
  pi && pi(e);
  var t = e.__c;
  t && t.__H && (t.__H.__h.length && gi(bi.push(t)), t.__H.__.some(function(n) {
    n.u && (n.__H = n.u);
  })), Vo = re = null;
}, j.__c = function(e, t) {
  t.some(function(n) {
    try {
      n.__h.some(Gt), n.__h = n.__h.filter(function(o) {
        return !o.__ || Ro(o);
      });
    } catch (o) {
      n.__h = [function() {
        throw o;
      }];
    }
  }), di && di(e, t);
}, j.unmount = function(e) {
  mi && mi(e);
  var t, n, o = e.__c;
  o && o.__H && (o.__H.__.some(function(r) {
    try {
      if (r.__P && r.__c) {
        if (n === void 0) {
          for (n = e.__; n && (!n.__c || !n.__c.__P); ) n = n.__;
          n = n && n.__c;
        }
        r.__P = n, gi(Ao.push(r));
      } else Gt(r);
    } catch (i) {
      t = i;
    }
  }), o.__H = void 0, t && j.__e(t, o.__v));
};
var vi = typeof requestAnimationFrame == "function";
function ys(e) {
  var t, n = function() {
    clearTimeout(o), vi && cancelAnimationFrame(t), setTimeout(e);
  }, o = setTimeout(n, 35);
  vi && (t = requestAnimationFrame(n));
}
function gi(e) {
  e != 1 && ui == j.requestAnimationFrame || ((ui = j.requestAnimationFrame) || ys)(bs);
}
function Gt(e) {
  var t = re, n = e.__c;
  typeof n == "function" && (e.__c = void 0, n()), re = t;
}
function Ro(e) {
  var t = re;
  e.__c = e.__(), re = t;
}
function Ho(e, t) {
  return !e || e.length != t.length || t.some(function(n, o) {
    return !vs(n, e[o]);
  });
}

// node_modules/@preact/signals-core/dist/signals-core.module.js
var _s = /* @__PURE__ */ Symbol.for("preact-signals");
function Rn() {
  if (Re > 1)
    Re--;
  else {
    var e, t = !1;
    for ((function() {
      var r = In;
      for (In = void 0; r !== void 0; ) {
        var i = r.S;
        if (i.v === r.v) for (var a = i.t; a !== void 0; a = a.x) a.i === r.i && (a.i = i.i);
        r = r.o;
      }
    })(); Qt !== void 0; ) {
      var n = Qt;
      for (Qt = void 0, Vn++; n !== void 0; ) {
        var o = n.u;
        if (n.u = void 0, n.f &= -3, !(8 & n.f) && _i(n)) try {
          n.c();
        } catch (r) {
          t || (e = r, t = !0);
        }
        n = o;
      }
    }
    if (Vn = 0, Re--, t) throw e;
  }
}
function On(e) {
  if (Re > 0) return e();
  Ko = ++ws, Re++;
  try {
    return e();
  } finally {
    Rn();
  }
}
var Yt, O = void 0;
function ie(e) {
  var t = O, n = Yt;
  O = void 0, Yt = void 0;
  try {
    return e();
  } finally {
    O = t, Yt = n;
  }
}
var Qt = void 0, Re = 0, Vn = 0, ws = 0, Ko = 0, In = void 0, An = 0;
function yi(e) {
  if (O !== void 0) {
    var t = e.n;
    if (t === void 0 || t.t !== O)
      return t = { i: 0, S: e, p: O.s, n: void 0, t: O, e: void 0, x: void 0, r: t }, O.s !== void 0 && (O.s.n = t), O.s = t, e.n = t, 32 & O.f && e.S(t), t;
    if (t.i === -1)
      return t.i = 0, t.n !== void 0 && (t.n.p = t.p, t.p !== void 0 && (t.p.n = t.n), t.p = O.s, t.n = void 0, O.s.n = t, O.s = t), t;
  }
}
function Y(e, t) {
  this.v = e, this.i = 0, this.n = void 0, this.t = void 0, this.l = 0, this.W = t?.watched, this.Z = t?.unwatched, this.name = t?.name;
}
Y.prototype.brand = _s;
Y.prototype.h = function() {
  return !0;
};
Y.prototype.S = function(e) {
  var t = this, n = this.t;
  n !== e && e.e === void 0 && (e.x = n, this.t = e, n !== void 0 ? n.e = e : ie(function() {
    var o;
    (o = t.W) == null || o.call(t);
  }));
};
Y.prototype.U = function(e) {
  var t = this;
  if (this.t !== void 0) {
    var n = e.e, o = e.x;
    n !== void 0 && (n.x = o, e.e = void 0), o !== void 0 && (o.e = n, e.x = void 0), e === this.t && (this.t = o, o === void 0 && ie(function() {
      var r;
      (r = t.Z) == null || r.call(t);
    }));
  }
};
Y.prototype.subscribe = function(e) {
  var t = this;
  return T(function() {
    var n = t.value;
    ie(function() {
      return e(n);
    });
  }, { name: "sub" });
};
Y.prototype.valueOf = function() {
  return this.value;
};
Y.prototype.toString = function() {
  return this.value + "";
};
Y.prototype.toJSON = function() {
  return this.value;
};
Y.prototype.peek = function() {
  var e = this;
  return ie(function() {
    return e.value;
  });
};
Object.defineProperty(Y.prototype, "value", { get: function() {
  var e = yi(this);
  return e !== void 0 && (e.i = this.i), this.v;
}, set: function(e) {
  if (e !== this.v) {
    if (Vn > 100) throw new Error("Cycle detected");
    (function(n) {
      Re !== 0 && Vn === 0 && n.l !== Ko && (n.l = Ko, In = { S: n, v: n.v, i: n.i, o: In });
    })(this), this.v = e, this.i++, An++, Re++;
    try {
      for (var t = this.t; t !== void 0; t = t.x) t.t.N();
    } finally {
      Rn();
    }
  }
} });
function g(e, t) {
  return new Y(e, t);
}
function _i(e) {
  for (var t = e.s; t !== void 0; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return !0;
  return !1;
}
function wi(e) {
  for (var t = e.s; t !== void 0; t = t.n) {
    var n = t.S.n;
    if (n !== void 0 && (t.r = n), t.S.n = t, t.i = -1, t.n === void 0) {
      e.s = t;
      break;
    }
  }
}
function ki(e) {
  for (var t = e.s, n = void 0; t !== void 0; ) {
    var o = t.p;
    t.i === -1 ? (t.S.U(t), o !== void 0 && (o.n = t.n), t.n !== void 0 && (t.n.p = o)) : n = t, t.S.n = t.r, t.r !== void 0 && (t.r = void 0), t = o;
  }
  e.s = n;
}
function tt(e, t) {
  Y.call(this, void 0, t), this.x = e, this.s = void 0, this.g = An - 1, this.f = 4;
}
tt.prototype = new Y();
tt.prototype.h = function() {
  if (this.f &= -3, 1 & this.f) return !1;
  if ((36 & this.f) == 32 || (this.f &= -5, this.g === An)) return !0;
  if (this.g = An, this.f |= 1, this.i > 0 && !_i(this))
    return this.f &= -2, !0;
  var e = O;
  try {
    wi(this), O = this;
    var t = this.x();
    (16 & this.f || this.v !== t || this.i === 0) && (this.v = t, this.f &= -17, this.i++);
  } catch (n) {
    this.v = n, this.f |= 16, this.i++;
  }
  return O = e, ki(this), this.f &= -2, !0;
};
tt.prototype.S = function(e) {
  if (this.t === void 0) {
    this.f |= 36;
    for (var t = this.s; t !== void 0; t = t.n) t.S.S(t);
  }
  Y.prototype.S.call(this, e);
};
tt.prototype.U = function(e) {
  if (this.t !== void 0 && (Y.prototype.U.call(this, e), this.t === void 0)) {
    this.f &= -33;
    for (var t = this.s; t !== void 0; t = t.n) t.S.U(t);
  }
};
tt.prototype.N = function() {
  if (!(2 & this.f)) {
    this.f |= 6;
    for (var e = this.t; e !== void 0; e = e.x) e.t.N();
  }
};
Object.defineProperty(tt.prototype, "value", { get: function() {
  if (1 & this.f) throw new Error("Cycle detected");
  var e = yi(this);
  if (this.h(), e !== void 0 && (e.i = this.i), 16 & this.f) throw this.v;
  return this.v;
} });
function N(e, t) {
  return new tt(e, t);
}
function xi(e) {
  var t = e.j;
  if (e.j = void 0, typeof t == "function") {
    Re++;
    var n = O;
    O = void 0;
    try {
      t();
    } catch (o) {
      throw e.f &= -2, e.f |= 8, Do(e), o;
    } finally {
      O = n, Rn();
    }
  }
}
function Do(e) {
  for (var t = e.s; t !== void 0; t = t.n) t.S.U(t);
  e.x = void 0, e.s = void 0, xi(e);
}
function ks(e) {
  if (O !== this) throw new Error("Out-of-order effect");
  ki(this), O = e, this.f &= -2;
  try {
    8 & this.f && Do(this);
  } finally {
    Rn();
  }
}
function bt(e, t) {
  this.x = e, this.j = void 0, this.s = void 0, this.u = void 0, this.f = 32, this.name = t?.name, Yt && Yt.push(this);
}
bt.prototype.c = function() {
  var e = this.S();
  try {
    if (8 & this.f || this.x === void 0) return;
    var t = this.x();
    typeof t == "function" && (this.j = t);
  } finally {
    e();
  }
};
bt.prototype.S = function() {
  if (1 & this.f) throw new Error("Cycle detected");
  this.f |= 1, this.f &= -9, xi(this), wi(this), Re++;
  var e = O;
  return O = this, ks.bind(this, e);
};
bt.prototype.N = function() {
  2 & this.f || (this.f |= 2, this.u = Qt, Qt = this);
};
bt.prototype.d = function() {
  this.f |= 8, 1 & this.f || Do(this);
};
bt.prototype.dispose = function() {
  this.d();
};
function T(e, t) {
  var n = new bt(e, t);
  try {
    n.c();
  } catch (r) {
    throw n.d(), r;
  }
  var o = n.d.bind(n);
  return o[Symbol.dispose] = o, o;
}

// node_modules/@preact/signals/dist/signals.module.js
var Fo, Zt, Hn, xs = typeof window < "u" && !!window.__PREACT_SIGNALS_DEVTOOLS__, Si = [], Mi = [];
T(function() {
  Fo = this.N;
})();
function yt(e, t) {
  E[e] = t.bind(null, E[e] || function() {
  });
}
function Jt(e) {
  if (Hn) {
    var t = Hn;
    Hn = void 0, t();
  }
  Hn = e && e.S();
}
function Ci(e) {
  var t = this, n = e.data, o = nt(n);
  o.name = "ReactiveDom", o.value = n;
  var r = Ln(function() {
    for (var s = t, p = t.__v; p = p.__; ) if (p.__c) {
      p.__c.__$f |= 4;
      break;
    }
    var c = N(function() {
      var f = o.value.value;
      return f === 0 ? 0 : f === !0 ? "" : f || "";
    }), u = N(function() {
      return !Array.isArray(c.value) && !Mo(c.value);
    }), d = T(function() {
      if (this.N = Ei, u.value) {
        var f = c.value;
        s.__v && s.__v.__e && s.__v.__e.nodeType === 3 && (s.__v.__e.data = f);
      }
    }), m = t.__$u.d;
    return t.__$u.d = function() {
      d(), m.call(this);
    }, [u, c];
  }, []), i = r[0], a = r[1];
  return i.value ? a.peek() : a.value;
}
Ci.displayName = "ReactiveTextNode";
Object.defineProperties(Y.prototype, { constructor: { configurable: !0, value: ti(X, null).constructor }, type: { configurable: !0, value: Ci }, props: { configurable: !0, get: function() {
  var e = this;
  return { data: { get value() {
    return e.value;
  } } };
} }, __b: { configurable: !0, value: 1 } });
yt("__b", function(e, t) {
  if (Jt(), Zt = void 0, typeof t.type == "string") {
    var n, o = t.props;
    for (var r in o) if (r !== "children") {
      var i = o[r];
      i instanceof Y && (n || (t.__np = n = {}), n[r] = i, o[r] = i.peek());
    }
  }
  e(t);
});
yt("__r", function(e, t) {
  if (e(t), t.type !== X) {
    Jt();
    var n, o = t.__c;
    o && (o.__$f &= -2, (n = o.__$u) === void 0 && (o.__$u = n = (function(r, i) {
      var a;
      return T(function() {
        a = this;
      }, { name: i }), a.c = r, a;
    })(/* @__PURE__ */ (function(r) {
      return function() {
        var i;
        xs && ((i = this.y) == null || i.call(this)), r.__$f |= 1, r.setState({});
      };
    })(o), typeof t.type == "function" ? t.type.displayName || t.type.name : ""))), Zt = o, Jt(n);
  }
});
yt("__e", function(e, t, n, o) {
  Jt(), Zt = void 0, e(t, n, o);
});
yt("diffed", function(e, t) {
  Jt(), Zt = void 0;
  var n;
  if (typeof t.type == "string" && (n = t.__e)) {
    var o = t.__np, r = t.props, i = n.U;
    if (i) for (var a in i) {
      var s = i[a];
      s === void 0 || o && a in o || (s.d(), i[a] = void 0);
    }
    if (o) {
      i || (i = {}, n.U = i);
      for (var p in o) {
        var c = i[p], u = o[p];
        c === void 0 ? (c = Ss(n, p, u, r), i[p] = c) : c.o(u, r);
      }
    }
  }
  e(t);
});
function Ss(e, t, n, o) {
  var r = t in e && e.ownerSVGElement === void 0, i = g(n);
  return { o: function(a, s) {
    i.value = a, o = s;
  }, d: T(function() {
    this.N = Ei;
    var a = i.value.value;
    o[t] !== a && (o[t] = a, r ? e[t] = a : a != null && (a !== !1 || t[4] === "-") ? e.setAttribute(t, a) : e.removeAttribute(t));
  }) };
}
yt("unmount", function(e, t) {
  if (typeof t.type == "string") {
    var n = t.__e;
    if (n) {
      var o = n.U;
      if (o) {
        n.U = void 0;
        for (var r in o) {
          var i = o[r];
          i && i.d();
        }
      }
    }
    var a = t.__np;
    if (a) {
      var s = t.props;
      for (var p in a) s[p] = a[p];
    }
    t.__np = void 0;
  } else {
    var c = t.__c;
    if (c) {
      c.__$f |= 8;
      var u = c.__$u;
      u && (c.__$u = void 0, u.d());
    }
  }
  e(t);
});
yt("__h", function(e, t, n, o) {
  o < 3 && (t.__$f |= 2), e(t, n, o);
});
gt.prototype.shouldComponentUpdate = function(e, t) {
  if (this.__R) return !0;
  var n = this.__$u, o = n && n.s !== void 0;
  for (var r in t) return !0;
  if (this.__f || typeof this.u == "boolean" && this.u === !0) {
    var i = 2 & this.__$f;
    if (!(o || i || 4 & this.__$f) || 1 & this.__$f) return !0;
  } else if (!(o || 4 & this.__$f) || 3 & this.__$f) return !0;
  for (var a in e) if (a !== "__source" && e[a] !== this.props[a]) return !0;
  for (var s in this.props) if (!(s in e)) return !0;
  return !1;
};
function nt(e, t) {
  return Ln(function() {
    return g(e, t);
  }, []);
}
var Ms = typeof requestAnimationFrame > "u" ? setTimeout : function(e) {
  var t = function() {
    clearTimeout(n), cancelAnimationFrame(o), e();
  }, n = setTimeout(t, 35), o = requestAnimationFrame(t);
}, Cs = function(e) {
  queueMicrotask(function() {
    queueMicrotask(e);
  });
};
function Es() {
  On(function() {
    for (var e; e = Si.shift(); ) Fo.call(e);
  });
}
function Ts() {
  Si.push(this) === 1 && (E.requestAnimationFrame || Ms)(Es);
}
function Ps() {
  On(function() {
    for (var e; e = Mi.shift(); ) Fo.call(e);
  });
}
function Ei() {
  Mi.push(this) === 1 && (E.requestAnimationFrame || Cs)(Ps);
}
function Ti(e, t) {
  var n = te(e);
  n.current = e;
  var o = Zt;
  Ce(function() {
    return T(function() {
      if (this.N = Ts, !(o && 8 & o.__$f)) return n.current();
    }, t);
  }, []);
}

// src/vec.ts
var I = (e, t) => [e[0] + t[0], e[1] + t[1], e[2] + t[2]], K = (e, t) => [e[0] - t[0], e[1] - t[1], e[2] - t[2]], S = (e, t) => [e[0] * t, e[1] * t, e[2] * t], q = (e, t) => e[0] * t[0] + e[1] * t[1] + e[2] * t[2], ge = (e, t) => [
  e[1] * t[2] - e[2] * t[1],
  e[2] * t[0] - e[0] * t[2],
  e[0] * t[1] - e[1] * t[0]
], Oe = (e) => Math.hypot(e[0], e[1], e[2]), He = (e, t) => Oe(K(e, t)), $s = (e, t, n) => I(S(e, 1 - n), S(t, n));
function J(e, t = [0, 0, 1]) {
  let n = Oe(e);
  return n > 1e-12 ? S(e, 1 / n) : t;
}
function ot(e) {
  let t = Math.abs(e[0]) < 0.7 * Oe(e) ? [1, 0, 0] : [0, 1, 0];
  return J(ge(t, e));
}
function en(e, t, n) {
  let o = Math.cos(n), r = Math.sin(n);
  return I(I(S(e, o), S(ge(t, e), r)), S(t, q(t, e) * (1 - o)));
}
function _t([e, t]) {
  return Array.from({ length: 8 }, (n, o) => [
    o & 1 ? t[0] : e[0],
    o & 2 ? t[1] : e[1],
    o & 4 ? t[2] : e[2]
  ]);
}
var qe = ([e, t]) => $s(e, t, 0.5);

// src/camera.ts
var No = Math.PI / 180, Kn = 89 * No;
function wt(e, t, n) {
  let o = J(K(e.target, e.eye), [0, 0, -1]), r = J(ge(o, e.up), ot(o)), i = ge(r, o), a = e.height != null && e.height > 0, s = a ? e.height / n : 2 * Math.tan(e.fov * No * 0.5) / n;
  return { eye: e.eye, forward: o, side: r, up: i, width: t, height: n, pixel: s, parallel: a };
}
function tn(e, t) {
  let n = K(t, e.eye), o = q(n, e.forward), r = e.parallel ? e.pixel : e.pixel * o;
  return [e.width / 2 + q(n, e.side) / r, e.height / 2 - q(n, e.up) / r, o];
}
function Ls(e, t, n) {
  let o = (t - e.width / 2) * e.pixel, r = (e.height / 2 - n) * e.pixel, i = I(S(e.side, o), S(e.up, r));
  return e.parallel ? { origin: I(e.eye, i), direction: e.forward } : { origin: e.eye, direction: J(I(e.forward, i)) };
}
function Pi(e, t, n, o) {
  let r = K(e.target, e.eye), i = Math.max(Oe(r), 1e-3), a = Math.asin(Math.max(-1, Math.min(1, q(J(r), t)))), s = K(r, S(t, q(r, t))), p = J(Oe(s) > 1e-6 * i ? s : K(e.up, S(t, q(e.up, t))), ot(t)), c = Math.max(-Kn, Math.min(Kn, a + o)), u = en(p, t, n), d = I(S(u, Math.cos(c)), S(t, Math.sin(c)));
  return { ...e, up: t, target: I(e.eye, S(d, i)) };
}
function $i(e, t, n, o, r) {
  let i = K(e.target, e.eye), a = K(i, S(t, q(i, t))), s = J(Oe(a) > 1e-6 ? a : e.up, ot(t)), p = J(ge(s, t)), c = I(I(S(s, n), S(p, o)), S(t, r));
  return je(e, c);
}
function Li(e, t, n, o, r) {
  let i = J(K(e.target, e.eye)), a = J(ge(i, e.up), ot(i));
  return je(e, I(I(S(i, n), S(a, o)), S(t, r)));
}
function je(e, t) {
  return { ...e, eye: I(e.eye, t), target: I(e.target, t) };
}
function Vi(e, t, n, o, r) {
  let i = J(K(e.target, e.eye)), a = Math.asin(Math.max(-1, Math.min(1, q(i, t)))), s = Math.max(-Kn, Math.min(Kn, a + r)), p = J(ge(i, t), J(ge(i, e.up), ot(i))), c = (u) => en(en(u, p, s - a), t, o);
  return {
    ...e,
    up: t,
    eye: I(n, c(K(e.eye, n))),
    target: I(n, c(K(e.target, n)))
  };
}
function Ii(e, t, n, o, r) {
  let i = t.parallel ? t.pixel : t.pixel * r;
  return je(e, I(S(t.side, -n * i), S(t.up, o * i)));
}
function Dn(e, t, n, o, r) {
  let i = K(t, e.eye), a = Oe(i);
  if (a < 1e-9) return e;
  let s = a * (1 - n);
  return r ? s = Math.sign(s) * Math.max(Math.abs(s), 0.5 * Math.abs(1 - n)) : s > 0 && (s = Math.max(0, Math.min(s, a - o))), je(e, S(i, s / a));
}
function Fn(e, t, n, o, r) {
  let i = Math.max(0.05, Math.min(1e5, (e.height ?? 1) * r)), a = (1 - i / (e.height ?? 1)) * t.pixel, s = I(
    S(t.side, (n - t.width / 2) * a),
    S(t.up, (t.height / 2 - o) * a)
  );
  return { ...je(e, s), height: i };
}
function Ai(e, t, n = 0.4) {
  let o = qe(t), r = Math.max(He(t[0], t[1]) / 2, 0.5), i = J(K(e.eye, e.target));
  if (e.height) {
    let s = q(K(e.eye, o), i);
    return { ...e, eye: I(o, S(i, s)), target: o, height: r * 3 };
  }
  let a = Math.max(1.5 * r / Math.tan(e.fov * No * 0.5), n + r);
  return { ...e, eye: I(o, S(i, a)), target: o };
}
var Vs = ["plan", "ceiling", "north", "east", "south", "west"];
function Ri(e) {
  let t = Math.abs(e[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], n = J(ge(e, t));
  return { right: J(ge(n, e)), ahead: n };
}
function Oi(e, t, n, o) {
  let { right: r, ahead: i } = Ri(n), a = qe(t), s = (b) => Math.abs(q(K(t[1], t[0]), b)), c = {
    plan: { forward: S(n, -1), up: i, side: r, cut: 0.15 },
    ceiling: { forward: n, up: S(i, -1), side: r, cut: 0.35 },
    north: { forward: i, up: n, side: r, cut: 0.25 },
    south: { forward: S(i, -1), up: n, side: r, cut: 0.25 },
    east: { forward: r, up: n, side: i, cut: 0.25 },
    west: { forward: S(r, -1), up: n, side: i, cut: 0.25 }
  }[e], u = s(c.forward), d = 1, m = K(a, S(c.forward, u / 2 + d)), f = 1.08 * Math.max(s(c.up), s(c.side) / o, 0.1);
  return { eye: m, target: a, up: c.up, fov: 50, height: f, near: d + u * c.cut };
}
function nn(e, t) {
  let n = (r, i) => He(r, i) < 1e-4, o = (r, i) => Math.abs((r ?? -1) - (i ?? -1)) < 1e-4;
  return n(e.eye, t.eye) && n(e.target, t.target) && n(e.up, t.up) && o(e.fov, t.fov) && o(e.height, t.height) && o(e.near, t.near);
}

// src/counters.ts
var ae = {
  frame: 0,
  seqApplied: 0,
  frames: [],
  sent: [],
  entered: 0,
  firstDrawn: 0
}, Hi = 0;
for (let e of ["input", "pointermove", "pointerdown", "keydown", "wheel"])
  addEventListener(e, (t) => Hi = t.timeStamp, { capture: !0, passive: !0 });
function Ki(e, t) {
  ae.sent.push({ seq: e, what: t, at: performance.now(), input: Hi }), ae.sent.length > 1024 && ae.sent.shift();
}
function Di(e) {
  ae.frame = e.frame, ae.seqApplied = e.seq, ae.firstDrawn ||= e.drawn, ae.frames.push(e), ae.frames.length > 1024 && ae.frames.shift(), requestAnimationFrame(() => {
    let t = new MessageChannel();
    t.port1.onmessage = () => {
      e.painted = performance.now(), t.port1.close();
    }, t.port2.postMessage(0);
  });
}
window.__desk = ae;

// src/store.ts
var Nn = /* @__PURE__ */ new Set(), kt = (e) => typeof e == "object" && e !== null && !Array.isArray(e);
function an(e, t) {
  if (!kt(e) || !kt(t)) return t;
  let n = { ...e };
  for (let [o, r] of Object.entries(t)) n[o] = an(n[o], r);
  return n;
}
var on = class {
  constructor(t) {
    this.server = t;
    this.shown = g(t);
  }
  server;
  shown;
  own = /* @__PURE__ */ new Map();
  /** The server's word. */
  receive(t) {
    this.server = t, this.show();
  }
  /** The page's word, until a patch of `seq`; infinite while it is held. */
  keep(t, n) {
    for (let [o, r] of Object.entries(t)) {
      let i = this.shown.peek()[o];
      this.own.set(o, { value: an(i, r), seq: n });
    }
    Nn.add(this), this.show();
  }
  /** The hand has let go: these fields wait for a patch of `seq` from now on. */
  settle(t, n) {
    for (let o of Object.keys(t)) {
      let r = this.own.get(o);
      r && (r.seq = n);
    }
  }
  /** Forgets what the server has followed. */
  release(t) {
    let n = !1;
    for (let [o, r] of this.own)
      r.seq <= t && (n = this.own.delete(o) || n);
    this.own.size === 0 && Nn.delete(this), n && this.show();
  }
  show() {
    if (this.own.size === 0) {
      this.shown.value = this.server;
      return;
    }
    let t = {};
    for (let [n, o] of this.own) t[n] = o.value;
    this.shown.value = { ...this.server, ...t };
  }
};
function Fi(e) {
  let { name: t, group: n, lamps: o } = e;
  return `${t} ${n} ${o}`;
}
var Ee = class {
  /** Numbers of the entries there are, ascending; changes only when one comes or goes. */
  ids = g([]);
  /** Grows when an entry is called otherwise or belongs elsewhere: what lists are made of. */
  order = g(0);
  entries = /* @__PURE__ */ new Map();
  get(t) {
    if (t == null) return;
    let n = this.entries.get(t);
    if (n) return n.shown.value;
    this.ids.value;
  }
  has(t) {
    return this.ids.value, this.entries.has(t);
  }
  entry(t) {
    return this.entries.get(t);
  }
  /** All entries as they are; whoever asks inside of an effect hears only of what changes lists. */
  listed() {
    return this.order.value, this.ids.value.map((t) => [t, this.entries.get(t).shown.peek()]);
  }
  /** All entries; whoever asks inside of an effect hears of each change. */
  all() {
    return this.ids.value.map((t) => [t, this.entries.get(t).shown.value]);
  }
  whole(t) {
    let n = /* @__PURE__ */ new Map();
    for (let [o, r] of Object.entries(t ?? {})) n.set(Number(o), new on(r));
    this.entries = n, this.number();
  }
  patch(t) {
    let n = !1;
    for (let [o, r] of Object.entries(t)) {
      let i = Number(o), a = this.entries.get(i);
      r === null ? n = this.entries.delete(i) || n : a ? (Fi(a.shown.peek()) !== Fi(r) && this.order.value++, a.receive(r)) : (this.entries.set(i, new on(r)), n = !0);
    }
    n && this.number();
  }
  number() {
    this.ids.value = [...this.entries.keys()].sort((t, n) => t - n);
  }
}, M = new Ee(), D = new Ee(), be = new Ee(), xt = new Ee(), St = new Ee(), Mt = new Ee(), Ct = new Ee(), qn = new Ee(), rn = {
  lamps: M,
  groups: D,
  things: be,
  materials: xt,
  views: St,
  looks: Mt,
  meters: Ct,
  grids: qn
}, Z = g(null), sn = g([]), ke = g([]), rt = g({ undo: null, redo: null, steps: 0 }), it = g({ state: "clean", file: "" }), F = g({ you: !0, name: null }), Te = g(null), jn = new on({
  ev: null,
  metered: !1,
  tone: "filmic",
  white: null,
  false_color: null
}), at = jn.shown, qo = {
  scene: Z,
  layers: sn,
  solo: ke,
  history: rt,
  saved: it,
  editor: F,
  status: Te
};
function Ni(e) {
  Nn.clear();
  for (let [t, n] of Object.entries(rn)) n.whole(e[t]);
  for (let [t, n] of Object.entries(qo)) t in e && (n.value = e[t]);
  kt(e.display) && jn.receive(e.display);
}
function qi(e, t) {
  for (let [n, o] of Object.entries(e))
    n in rn ? rn[n].patch(o) : n === "display" ? jn.receive(o) : n in qo && (qo[n].value = o);
  Et(t);
}
function Et(e) {
  for (let t of [...Nn]) t.release(e);
}
function ji(e, t) {
  for (let [n, o] of Object.entries(e))
    if (n in rn && kt(o))
      for (let [r, i] of Object.entries(o)) {
        let a = rn[n].entry(Number(r));
        a && kt(i) && t(a, i);
      }
    else n === "display" && kt(o) && t(jn, o);
}
var jo = (e, t) => ji(e, (n, o) => n.keep(o, t)), Un = (e, t) => ji(e, (n, o) => n.settle(o, t));
function st(e) {
  let t = D.get(e.group);
  return e.on && !e.parked && (t?.on ?? !0) ? e.level * (t?.level ?? 1) : 0;
}
function Uo(e) {
  return e.reduce((t, n) => {
    let o = M.get(n);
    return t + (o ? o.flux * st(o) : 0);
  }, 0);
}
var Ui = N(() => {
  let e = M.all();
  return e.length > 0 && e.every(([, t]) => st(t) === 0);
});
function Is(e, t) {
  let n = t.trim().toLowerCase();
  return e.all().filter(([, o]) => !n || o.name.toLowerCase().includes(n));
}

// src/wire.ts
var U = g("entering"), cn = g(0), pe = g("edit"), Wn = g(null), Ke = g(0), Wi = () => null, Bi = (e) => {
  Wi = e;
}, Bn = /* @__PURE__ */ new Map(), Ue = null, ln = 0, Wo = null, un = 0, Tt = "", zn = !1;
function xe(e, t) {
  let n = Bn.get(e) ?? /* @__PURE__ */ new Set();
  return Bn.set(e, n.add(t)), () => n.delete(t);
}
function H(e) {
  return !Ue || Ue.readyState !== WebSocket.OPEN || U.peek() !== "open" ? 0 : (ln += 1, Ue.send(JSON.stringify({ ...e, seq: ln })), e.do !== "ack" && Ki(ln, e.do), ln);
}
var As = 0, lt = /* @__PURE__ */ new Map();
function Se(e, t, n, o = () => {
}) {
  let r = ++As, i = xe("answer", (s) => {
    s.id === r && (s.done !== !1 && i(), n(s));
  }), a = H({ do: "ask", id: r, what: e, ...t });
  if (!a)
    return i(), o("There is no connection to the program."), i;
  lt.set(a, (s) => {
    i(), o(s);
  });
  for (let s of lt.keys()) {
    if (s > a - 300) break;
    lt.delete(s);
  }
  return i;
}
function Rs(e) {
  switch (e.is) {
    case "hello":
      if (un = 0, Wo !== null && e.build !== Wo) {
        U.value = "renewed", Ue?.close();
        return;
      }
      Wo = e.build, pe.value = e.role === "watch" ? "watch" : "edit", Wn.value = e.you === void 0 ? null : String(e.you), Ke.value = 0, lt.clear(), U.value = "open";
      break;
    case "state":
      Ni(e.state ?? e);
      break;
    case "patch":
      (e.by == null || String(e.by) === Wn.value) && Bo(e.seq), qi(e.patch ?? {}, Ke.value);
      break;
    case "status":
      Te.value = e;
      break;
    case "refused":
      if (Bo(e.seq), Et(Ke.value), lt.has(e.seq)) {
        lt.get(e.seq)?.(e.why ?? ""), lt.delete(e.seq);
        return;
      }
      break;
    case "event":
      e.what === "bye" && (zn = !0);
      break;
  }
  for (let t of [...Bn.get(e.is) ?? []]) t(e);
}
function Bo(e) {
  typeof e == "number" && e > Ke.value && (Ke.value = e);
}
async function zi() {
  if (!Tt) return "in";
  try {
    return (await fetch("/enter", {
      method: "POST",
      headers: { "content-type": "application/json" },
      body: JSON.stringify({ key: Tt })
    })).ok ? "in" : "denied";
  } catch {
    return "away";
  }
}
function Gi() {
  let e = location.protocol === "https:" ? "wss" : "ws", t = new WebSocket(`${e}://${location.host}/wire`);
  t.binaryType = "arraybuffer";
  let n = !1;
  Ue = t, Bn.get("line")?.forEach((o) => o({ is: "line" })), t.onmessage = (o) => {
    if (t !== Ue) return;
    if (typeof o.data != "string") {
      let i = Wi(o.data);
      i && F.value.you && Bo(i.seq);
      return;
    }
    let r = JSON.parse(o.data);
    r.is === "hello" && (n = !0, ln = 0), Rs(r);
  }, t.onclose = () => {
    t === Ue && (Ue = null, U.value !== "renewed" && Os(n));
  };
}
async function Os(e) {
  if (Et(1 / 0), !e && await Hs()) {
    let o = await zi();
    if (o === "denied" || o === "in" && un > 4 && !Tt) {
      U.value = "denied";
      return;
    }
  }
  un += 1;
  let t = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
  un > 3 && t && (zn = !0), U.value = zn ? "ended" : "lost";
  let n = Math.min(5, un);
  for (let o = n; o > 0; o--)
    cn.value = o, await new Promise((r) => setTimeout(r, 1e3));
  cn.value = 0, Gi();
}
async function Hs() {
  try {
    return await fetch("/", { cache: "no-store" }), !0;
  } catch {
    return !1;
  }
}
async function Xi() {
  let e = location.hash.slice(1);
  if (e ? (Tt = e, sessionStorage.setItem("lampyris-key", Tt), window.history.replaceState(null, "", location.pathname + location.search)) : Tt = sessionStorage.getItem("lampyris-key") ?? "", ae.entered = performance.now(), e && await zi() === "denied") {
    U.value = "denied";
    return;
  }
  Gi();
}
xe("hello", () => zn = !1);

// src/frames.ts
var W = g(null), $t = g(0), Yi = ["moving", "settled", "final"], Qi = 32, Pt = /* @__PURE__ */ new Map(), Pe = null, zo = null, Go = !1, ut = null;
function Ks(e) {
  if (e.byteLength < Qi) return null;
  let t = new DataView(e);
  return { head: {
    frame: t.getUint32(0, !0),
    seq: t.getUint32(4, !0),
    camera: t.getUint32(8, !0),
    width: t.getUint16(12, !0),
    height: t.getUint16(14, !0),
    kind: Yi[Math.min(t.getUint8(16), 2)],
    falseColor: (t.getUint8(18) & 1) === 1,
    batches: t.getUint32(20, !0),
    error: t.getFloat32(24, !0),
    light: t.getUint16(28, !0) / 10,
    encode: t.getUint16(30, !0) / 10
  }, mime: t.getUint8(17) === 1 ? "image/png" : "image/jpeg" };
}
function Ds(e) {
  let t = Ks(e);
  return t ? (ut && H({ do: "ack", frame: ut.head.frame }), ut = { ...t, bytes: e, received: performance.now() }, Go || Fs(), t.head) : null;
}
async function Fs() {
  for (Go = !0; ut; ) {
    let { head: e, mime: t, bytes: n, received: o } = ut;
    ut = null;
    try {
      let r = await createImageBitmap(new Blob([new Uint8Array(n, Qi)], { type: t }));
      Ns(e, r, n.byteLength, o);
    } catch {
    }
    H({ do: "ack", frame: e.frame });
  }
  Go = !1;
}
function Ns(e, t, n, o) {
  let r = performance.now();
  Pe && zo && ((Pe.width !== t.width || Pe.height !== t.height) && (Pe.width = t.width, Pe.height = t.height), zo.drawImage(t, 0, 0)), t.close();
  let i = Pt.get(e.camera) ?? W.peek()?.camera;
  i && (W.value = { head: e, camera: i }), qs(), Di({
    frame: e.frame,
    seq: e.seq,
    kind: Yi.indexOf(e.kind),
    width: e.width,
    height: e.height,
    bytes: n,
    batches: e.batches,
    received: o,
    decoded: r,
    drawn: performance.now(),
    painted: 0,
    light: e.light,
    encode: e.encode
  });
}
var Gn = [];
function qs() {
  let e = performance.now();
  Gn = Gn.filter((t) => e - t < 1e3), Gn.push(e), $t.value = Gn.length;
}
function Xo(e) {
  Pe = e, zo = e?.getContext("2d", { alpha: !1 }) ?? null;
}
function Ji() {
  if (!Pe || !W.peek()) return null;
  let e = document.createElement("canvas");
  return e.width = Pe.width, e.height = Pe.height, e.getContext("2d", { alpha: !1 })?.drawImage(Pe, 0, 0), e;
}
Bi(Ds);
xe("camera", (e) => {
  Pt.set(e.number, e);
  for (let t of Pt.keys()) {
    if (Pt.size <= 64) break;
    Pt.delete(t);
  }
});
xe("line", () => {
  Pt.clear(), ut = null;
});

// src/prefs.ts
var Zi = "lampyris-";
function ue(e, t) {
  let n = t;
  try {
    let r = localStorage.getItem(Zi + e);
    r !== null && (n = JSON.parse(r));
  } catch {
  }
  let o = g(n);
  return T(() => {
    let r = JSON.stringify(o.value);
    try {
      localStorage.setItem(Zi + e, r);
    } catch {
    }
  }), o;
}
var Yo = ue("theme", "dark"), Qo = ue("house-lights", 1), Xn = ue("hands", "default"), Jo = ue("walking", "walk"), Zo = ue("panels", !0), Lt = ue("listing", "faders"), Yn = ue("travel", "square"), Vt = ue("candles", "lx"), er = ue("single-keys", !0), tr = ue("lamp-marks", !0), js = ue("maintenance", 1), We = ue("fine", !1), nr = ue("fade", 1), Us = typeof matchMedia == "function" && matchMedia("(pointer: coarse)").matches, ye = ue("look-only", Us);

// src/say.ts
var ct = g([]), Ws = 0;
function se(e, t = "plain") {
  if (ct.peek().find((r) => r.text === e)) return;
  let o = ++Ws;
  ct.value = [...ct.peek().slice(-2), { id: o, text: e, tone: t }], setTimeout(() => or(o), t === "warn" ? 8e3 : 4e3);
}
function or(e) {
  ct.value = ct.peek().filter((t) => t.id !== e);
}

// src/gesture.ts
var It = 0, na = /* @__PURE__ */ new Set(), oa = (e) => {
  na.add(e);
}, fn = /* @__PURE__ */ new Set(), Qn = N(() => ye.value ? "The look-only lock is on." : pe.value === "watch" ? "You are watching. Ask for the pen to change things." : F.value.you ? null : `${F.value.name ?? "Somebody else"} has the pen. Take it to change things.`);
function Jn() {
  return U.value !== "open" ? "There is no connection to the program: nothing was changed." : Qn.value;
}
var ea = (e) => (e.length > 120 ? `${e.slice(0, 119)}…` : e).replace(/[\u0000-\u001f]/g, " "), Be = class {
  constructor(t) {
    this.label = t;
  }
  label;
  waiting = null;
  touched = {};
  under = 0;
  last = 0;
  state = "new";
  /** A new value of the control. */
  set(t) {
    this.state === "over" || !this.begin() || (jo(t, 1 / 0), this.touched = an(this.touched, t), this.waiting = an(this.waiting ?? {}, t), this.under <= Ke.peek() && this.flush());
  }
  /** Any other message that belongs to this step. */
  also(t) {
    this.state === "over" || !this.begin() || (this.flush(), this.last = H(t));
  }
  end(t) {
    this.state === "held" && (this.flush(), Un(this.touched, this.last), this.finish({ do: "end", ...t ? { label: ea(t) } : {} })), this.state = "over";
  }
  cancel() {
    this.state === "held" && (this.waiting = null, Un(this.touched, 0), this.finish({ do: "cancel" }), Et(0)), this.state = "over";
  }
  /** The server has followed so far. */
  followed() {
    this.waiting && this.under <= Ke.peek() && this.flush();
  }
  /** The line is gone, and with it what was held. */
  drop() {
    this.state = "over", fn.delete(this), It = 0;
  }
  begin() {
    if (this.state === "held") return !0;
    let t = ie(Jn);
    return t ? (se(t, "warn"), this.state = "over", !1) : (this.state = "held", fn.add(this), It === 0 && na.forEach((n) => n()), It++ === 0 && (this.last = H({ do: "begin", label: ea(this.label) })), !0);
  }
  flush() {
    this.waiting && (this.under = this.last = H({ do: "set", patch: this.waiting }), this.waiting = null);
  }
  finish(t) {
    fn.delete(this), It = Math.max(0, It - 1), It === 0 && H(t);
  }
};
function Le(e, t) {
  let n = new Be(e);
  n.set(t), n.end();
}
function Bs(e, t) {
  let n = new Be(e);
  n.also(t), n.end();
}
function At(e) {
  ie(() => U.value) === "open" && (jo({ display: e }, 1 / 0), Un({ display: e }, H({ do: "display", patch: e })));
}
var $e = null;
function rr(e, t, n) {
  $e && $e.key !== e && ta(), $e ??= { key: e, gesture: new Be(t), timer: 0 }, $e.gesture.set(n), clearTimeout($e.timer), $e.timer = window.setTimeout(ta, 700);
}
function ta() {
  $e && (clearTimeout($e.timer), $e.gesture.end(), $e = null);
}
T(() => {
  Ke.value, ie(() => [...fn].forEach((e) => e.followed()));
});
T(() => {
  U.value !== "open" && [...fn].forEach((e) => e.drop());
});

// src/before.ts
var pn = g(null), de = g(null), zs = g(0.5);
function Gs() {
  let e = W.peek(), t = Ji();
  e && t && (pn.value = { picture: t, camera: e.camera });
}
function ir() {
  de.peek() !== "wipe" && Gs();
}
oa(ir);
function ra() {
  let e = pn.peek(), t = W.peek();
  if (!e || !t) se("Nothing has been changed yet.");
  else if (!nn(e.camera, t.camera)) se("The picture before was taken from another place: go back there with Alt+←.", "warn");
  else return !0;
  return !1;
}
function dn(e) {
  e ? de.peek() === null && ra() && (de.value = "held") : de.peek() === "held" && (de.value = null);
}
function Xs() {
  de.value = de.peek() === "wipe" ? null : ra() ? "wipe" : null;
}

// src/select.ts
var P = g(null), me = g(null), z = g(null), Ys = g("move"), le = N(() => {
  let e = P.value;
  return e?.kind === "lamp" ? e.ids.filter((t) => M.has(t)) : e?.kind === "group" ? e.ids.flatMap((t) => D.get(t)?.lamps ?? []) : [];
});
function ze(e, t, n = "only") {
  let o = P.peek();
  if (n === "only" || o?.kind !== e) {
    P.value = { kind: e, ids: [t] };
    return;
  }
  let r = o.ids.includes(t);
  if (r && n === "add") return;
  let i = r ? o.ids.filter((a) => a !== t) : [...o.ids, t];
  P.value = i.length ? { kind: e, ids: i } : null;
}
function Zn() {
  P.value = null;
}
function ia(e, t, n) {
  let o = P.peek(), r = o?.kind === e ? t.indexOf(o.ids[o.ids.length - 1]) : -1;
  if (r < 0) return ze(e, n);
  let i = t.indexOf(n), [a, s] = r < i ? [r, i] : [i, r], p = t.slice(a, s + 1), c = (o?.ids ?? []).filter((u) => !p.includes(u));
  P.value = { kind: e, ids: [...c, ...r < i ? p : p.reverse()] };
}
function Qs(e) {
  let t = P.peek(), n = t?.kind ?? "lamp", o = n === "lamp" ? M.ids.peek() : n === "thing" ? be.ids.peek() : D.ids.peek();
  if (!o.length) return;
  let r = t ? o.indexOf(t.ids[t.ids.length - 1]) : e > 0 ? -1 : 0;
  ze(n, o[(r + e + o.length) % o.length]);
}
function aa(e, t) {
  switch (e) {
    case "lamp":
      return M.get(t)?.name ?? `lamp ${t}`;
    case "group":
      return D.get(t)?.name ?? `group ${t}`;
    case "thing":
      return be.get(t)?.name ?? `thing ${t}`;
    case "material":
      return xt.get(t)?.name ?? `material ${t}`;
    default:
      return `${e} ${t}`;
  }
}
function eo(e) {
  return e.length === 1 ? aa("lamp", e[0]) : `${e.length} lamps`;
}
function sa(e, t) {
  let n = [];
  if (e?.lamp != null) {
    n.push({ kind: "lamp", ids: [e.lamp] });
    let i = M.get(e.lamp)?.group;
    i != null && (D.get(i)?.lamps.length ?? 0) > 1 && n.push({ kind: "group", ids: [i] });
  }
  if (e?.thing != null && n.push({ kind: "thing", ids: [e.thing] }), !n.length) {
    t === "only" && Zn();
    return;
  }
  if (t !== "only") return ze(n[0].kind, n[0].ids[0], t);
  let o = P.peek(), r = n.findIndex((i) => o?.kind === i.kind && o.ids.length === 1 && o.ids[0] === i.ids[0]);
  P.value = n[(r + 1) % n.length];
}
var to = g(null);

// src/navigate.ts
var Js = 1.6, he = g(null), ua = N(() => pe.value === "edit" && F.value.you), Ve = N(() => Z.value?.up ?? [0, 0, 1]), _e = g([640, 480]), Ht = g(null), lr = null, mn = null, ar = !1, Ge = [], cr = [], ur = 0;
function Q(e, t = null) {
  let n = he.peek();
  if (n && nn(n, e)) return;
  let o = performance.now();
  n && (o - ur > 1e3 || t) && (Ge.push(n), Ge.length > 100 && Ge.shift(), cr.length = 0), ur = o, he.value = e, Ht.value = t;
}
var ne = () => he.peek();
function Zs() {
  ca(Ge, cr);
}
function el() {
  ca(cr, Ge);
}
function ca(e, t) {
  let n = e.pop();
  if (!n) return;
  let o = he.peek();
  o && t.push(o), ur = performance.now(), he.value = n, Ht.value = null;
}
T(() => {
  !he.value || U.value !== "open" || !ua.value || ar || (ar = !0, requestAnimationFrame(() => {
    ar = !1;
    let t = he.peek();
    if (!t || mn && nn(mn, t)) return;
    let { eye: n, target: o, up: r, fov: i, height: a, near: s } = t, p = { do: "camera", eye: n, target: o, up: r, fov: i };
    a && (p.height = a), s && (p.near = s), H(p) && (mn = t);
  }));
});
T(() => {
  let e = W.value;
  e && ie(() => {
    he.peek() && ua.peek() || (mn = e.camera, he.value = e.camera, lr ??= e.camera);
  });
});
xe("hello", () => mn = null);
function Kt(e, t) {
  let n = W.peek();
  if (!n) return null;
  let { head: o } = n, r = hn(o.width, o.height);
  return { frame: o.frame, x: (e - r.x) / r.scale, y: (t - r.y) / r.scale };
}
function hn(e, t) {
  let [n, o] = _e.peek(), r = Math.min(n / e, o / t);
  return { x: (n - e * r) / 2, y: (o - t * r) / 2, scale: r };
}
function ft(e = he.peek()) {
  let [t, n] = _e.peek();
  return e ? wt(e, t, n) : null;
}
var Ot = () => Z.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]], Dt = () => qe(Ot());
function no(e, t) {
  let n = ne();
  n && Q(Pi(n, Ve.peek(), e, t));
}
function oo(e, t, n) {
  let o = ne();
  o && Q(Vi(o, Ve.peek(), e, t, n));
}
function Ft(e, t, n) {
  let o = ne(), r = ft();
  o && r && Q(Ii(o, r, e, t, n));
}
function fa(e, t, n) {
  let o = ne();
  if (o) {
    if (o.height) {
      let r = ft(o);
      r && Q(je(o, I(S(r.side, t), S(r.up, e))));
      return;
    }
    Jo.peek() === "fly" || n !== 0 ? Q(Li(o, Ve.peek(), e, t, n)) : (Q($i(o, Ve.peek(), e, t, 0)), tl());
  }
}
var Rt = !1, sr = !0, la = null;
function tl() {
  let e = ne();
  if (!e || Rt || !sr) return;
  let t = Ve.peek();
  Rt = !0;
  let n = Se("ray", { origin: e.eye, direction: S(t, -1) }, (o) => {
    Rt = !1, sr = !0;
    let r = ne();
    if (!o.hit || !r || r.height) return;
    la = q(o.point, t);
    let i = la + Js - q(r.eye, t);
    Math.abs(i) > 0.01 && Q(je(r, S(t, i * 0.5)));
  }, () => {
    Rt = !1, sr = !1;
  });
  setTimeout(() => {
    Rt && n(), Rt = !1;
  }, 500);
}
function nl() {
  let e = P.peek();
  if (!e) return null;
  let t = [], n = (i, a) => {
    i ? t.push(i) : a && t.push([a, a]);
  };
  for (let i of e.ids)
    if (e.kind === "lamp" && n(M.get(i)?.box, M.get(i)?.place?.position), e.kind === "thing" && n(be.get(i)?.box), e.kind === "meter" && n(null, Ct.get(i)?.point), e.kind === "group")
      for (let a of D.get(i)?.lamps ?? []) n(M.get(a)?.box, M.get(a)?.place?.position);
  if (!t.length) return null;
  let o = t.flatMap(_t), r = (i) => [0, 1, 2].map((a) => i(...o.map((s) => s[a])));
  return [r(Math.min), r(Math.max)];
}
function fr() {
  let e = ne(), t = nl();
  e && t ? Q(Ai(e, t), "selection") : pr();
}
function pr() {
  lr && Q(lr, "home");
}
function ol(e) {
  let [t, n] = _e.peek();
  Q(Oi(e, Ot(), Ve.peek(), t / n), e);
}
function rl() {
  for (let e = Ge.length - 1; e >= 0; e--)
    if (!Ge[e].height) return Q(Ge[e], "inside");
  pr();
}
var il = N(() => {
  let e = he.value;
  if (!e?.height) return null;
  let t = wt(e, 2, 2), n = _t(Ot()).map((s) => q(K(s, e.eye), t.forward)), o = e.near ?? 0, r = q(t.forward, Ve.value), i = Math.min(..._t(Ot()).map((s) => q(s, Ve.value))), a = Math.abs(r) > 0.99 ? q(e.eye, Ve.value) + r * o - i : null;
  return { value: o, most: Math.max(...n), height: a };
});
function al(e) {
  let t = ne();
  t && (he.value = { ...t, near: Math.max(0, e) });
}

// src/tools.ts
var dr = g("spot"), pa = () => {
}, sl = (e) => {
  pa = e;
}, da = (e) => pa(e);
function mr(e) {
  z.value = z.peek() === e ? null : e;
}
var ro = (e) => Math.max(-1, ...e.ids.peek()) + 1;
function hr(e) {
  return e.kind === "sky" || e.kind === "parallel" ? null : e.place?.position ?? (e.box ? qe(e.box) : null);
}

// src/actions.ts
var pt = g(null), Ie = g("lamps"), gr = g("");
function ao(e) {
  let t = Jn();
  if (t) return se(t, "warn");
  (e.do === "look" ? e.what === "recall" : e.do !== "save") && ir(), H(e);
}
var ll = (e, t) => Object.fromEntries(e.map((n) => [n, t])), ul = {
  quantity: "illuminance",
  low: 1,
  high: 1e3,
  scale: "log",
  palette: "even",
  lines: !1
}, vr = ul, ma = ({ quantity: e, low: t, high: n, scale: o, palette: r, lines: i }) => ({ quantity: e, low: t, high: n, scale: o, palette: r, lines: i }), cl = () => at.peek().false_color ?? vr;
function br() {
  let e = at.peek().false_color;
  e && (vr = e), At({ false_color: e ? null : ma(vr) });
}
function so(e) {
  let t = Math.round(((at.peek().ev ?? 0) + e / 3) * 30) / 30;
  At({ ev: t });
}
function fl() {
  let e = ne();
  if (!e) return;
  let t = ro(St);
  Le("Store the view", { views: { [t]: { ...e, name: `View ${t + 1}` } } });
}
var pl = () => ao({ do: "look", what: "store", name: `Look ${ro(Mt) + 1}` });
async function yr(e) {
  let t = !1;
  try {
    await navigator.clipboard.writeText(e), t = !0;
  } catch {
    let n = document.createElement("textarea");
    n.value = e, n.className = "spoken", document.body.append(n), n.select(), t = document.execCommand("copy"), n.remove();
  }
  se(t ? "Copied." : `Copy it by hand: ${e}`);
}
var Nt = /* @__PURE__ */ new Map(), io = null;
function dl(e) {
  Nt = new Map(e.map((t) => [t.id, t])), io && oe(io), io = null;
}
var ml = () => [...Nt.values()], ha = (e) => Nt.get(e), _r = (e) => Nt.get(e)?.why?.() ?? null;
function oe(e) {
  let t = Nt.get(e);
  Nt.size || (io = e);
  let n = t?.why?.();
  n ? se(n, "warn") : t?.run();
}

// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var hl = /* @__PURE__ */ Symbol.for("pv"), vl = 0;
function l(e, t, n, o, r, i) {
  t || (t = {});
  var a, s, p = t;
  if ("ref" in p && typeof e != "function") for (s in p = {}, t) s == "ref" ? a = t[s] : p[s] = t[s];
  var c = { type: e, props: p, key: n, ref: a, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: hl, __v: --vl, __i: -1, __u: 0 };
  return (r || i) && (c.__source = r, c.__self = i), E.vnode && E.vnode(c), c;
}

// src/load.tsx
var ga = g(null), wr = !1, va = 0, kr = (e) => ga.value?.[e];
function ee({ part: e }) {
  let t = kr(e);
  return t ? l(t, {}) : null;
}
function ba() {
  T(() => {
    if (wr || !(W.value ?? P.value)) return;
    wr = !0;
    let e = `./gizmo.js${va++ ? `?${va}` : ""}`;
    setTimeout(() => {
      import(e).then((t) => ga.value = t, () => wr = !1);
    }, 0);
  });
}

// src/units.ts
var lo = 0.3048, ya = {
  level: { bare: 0.01, units: { "%": 0.01, x: 1, "×": 1 }, low: 0, high: 1e3, say: "a level such as 80 % or 450 lm" },
  flux: { bare: 1, units: { lm: 1, klm: 1e3 }, low: 0, high: 1e9, say: "a flux such as 450 lm" },
  kelvin: { bare: 1, units: { k: 1 }, low: 1e3, high: 25e3, say: "a colour temperature such as 2700 K" },
  angle: { bare: 1, units: { "°": 1, deg: 1, rad: 180 / Math.PI }, low: -36e3, high: 36e3, say: "an angle such as 30°" },
  length: {
    bare: 1,
    units: { m: 1, cm: 0.01, mm: 1e-3, km: 1e3, ft: lo, "'": lo, in: lo / 12, '"': lo / 12 },
    low: -1e6,
    high: 1e6,
    say: `a length such as 2.4 m, 75 cm or 8'2"`
  },
  lux: { bare: 1, units: { lx: 1, klx: 1e3, fc: 10.7639 }, low: 0, high: 1e9, say: "an illuminance such as 500 lx" },
  share: { bare: 1, units: { "%": 0.01 }, low: 0, high: 1, say: "a share from 0 to 1 or 0 to 100 %" },
  number: { bare: 1, units: {}, low: -1e9, high: 1e9, say: "a number" },
  ev: { bare: 1, units: { ev: 1, stop: 1, stops: 1 }, low: -30, high: 30, say: "an exposure such as 8.3" },
  seconds: { bare: 1, units: { s: 1, ms: 1e-3, min: 60 }, low: 0, high: 3600, say: "a time such as 2 s" }
}, gl = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;
function xr(e) {
  let t = gl.exec(e);
  if (!t) return null;
  let [n, o] = t[0].split("/").map(Number);
  return o === 0 ? null : { value: o === void 0 ? n : n / o, rest: e.slice(t[0].length).trimStart() };
}
function _a(e, t, n) {
  let o = e.trim(), r = 0, i = !0;
  for (; o; ) {
    let a = 1, s = /^[+-]\s*/.exec(o);
    s && !i && (a = o[0] === "-" ? -1 : 1, o = o.slice(s[0].length));
    let p = xr(o);
    if (!p) return null;
    let c = /^[a-zµ°%'"×]+/i.exec(p.rest)?.[0] ?? "", u = c === "" ? n : t.units[c.toLowerCase()];
    if (u === void 0) return null;
    r += a * p.value * u, o = p.rest.slice(c.length).trim(), i = !1;
  }
  return i ? null : r;
}
function wa(e, t, n) {
  let o = ya[t], r = e.trim().replace(/,(?=\d)/g, ".").replace(/[\u2009\u202f\u00a0]/g, "").replace(/−/g, "-"), i = { why: `“${e.trim()}” is not ${o.say}` }, a = (y) => ({
    apply: (w) => Math.min(o.high, Math.max(o.low, y(w)))
  });
  if (!r) return { why: `Type ${o.say}` };
  let s = r.toLowerCase();
  if (t === "level" && s === "full") return a(() => 1);
  if (t === "level" && (s === "out" || s === "off")) return a(() => 0);
  let p = /^(.*?)\s*(?:stops?|ev)$/i.exec(r);
  if (p && t !== "ev") {
    let y = xr(p[1].trim());
    return !y || y.rest || !["level", "flux", "lux", "number"].includes(t) ? i : a((w) => w * 2 ** y.value);
  }
  let c = /^([*/×÷])\s*(.+)$/.exec(r);
  if (c) {
    let y = xr(c[2]);
    if (!y) return i;
    let w = y.rest === "%" ? 0.01 : y.rest === "" ? 1 : NaN, x = y.value * w;
    return !Number.isFinite(x) || x === 0 && /[/÷]/.test(c[1]) ? i : a((k) => /[/÷]/.test(c[1]) ? k / x : k * x);
  }
  let d = t === "length" || t === "angle" || t === "ev" || t === "number" ? /^([+-])=\s*(.+)$/.exec(r) : /^([+-])=?\s*(.+)$/.exec(r), m = d ? d[2] : r, f = _a(m, o, o.bare);
  if (f === null && t === "level" && n) {
    let y = _a(m, { ...ya.flux }, NaN);
    f = y === null || Number.isNaN(y) ? null : y / n;
  }
  if (f === null || !Number.isFinite(f)) return i;
  let b = f;
  return d ? a((y) => d[1] === "-" ? y - b : y + b) : b < o.low || b > o.high ? { why: `${e.trim()} is out of range: ${o.say}` } : a(() => b);
}
function B(e, t = 0) {
  if (!Number.isFinite(e)) return "–";
  let [n, o] = Math.abs(e).toFixed(t).split("."), r = n.length > 4 ? n.replace(/\B(?=(\d{3})+$)/g, " ") : n;
  return (e < 0 && Number(Math.abs(e).toFixed(t)) !== 0 ? "−" : "") + r + (o ? `.${o}` : "");
}
function Xe(e) {
  let t = Math.abs(e);
  return B(e, t >= 99.95 || t === 0 ? 0 : t >= 9.995 ? 1 : t >= 0.9995 ? 2 : 3);
}
function Ae(e) {
  let t = e * 100;
  return B(t, t >= 9.95 || t === 0 ? 0 : t >= 0.95 ? 1 : 2);
}
function vn(e, t) {
  switch (t) {
    case "level":
      return `${Ae(e)} %`;
    case "flux":
      return `${Xe(e)} lm`;
    case "kelvin":
      return `${B(e)} K`;
    case "angle":
      return `${B(e, 1)}°`;
    case "length":
      return `${B(e, 2)} m`;
    case "lux":
      return `${Xe(e)} lx`;
    case "seconds":
      return `${B(e, 1)} s`;
    case "ev":
      return B(e, 1);
    case "share":
      return B(e, 2);
    case "number":
      return String(Math.round(e * 1e4) / 1e4);
  }
}
function dt(e, t = !0) {
  let n = Vt.value === "fc", o = n ? e / 10.7639 : e;
  return Xe(o) + (t ? n ? " fc" : " lx" : "");
}

// src/field.tsx
function gn(e) {
  let t = nt(null), n = nt(null), o = te(null), r = te(null), i = t.value ?? e.text ?? (e.value === null ? "mixed" : vn(e.value, e.quantity));
  Ce(() => {
    !e.open || !o.current || (t.value = e.open, o.current.focus(), o.current.setSelectionRange(e.open.length, e.open.length), e.opened?.());
  }, [e.open]);
  let a = () => {
    if (t.value === null) return;
    let d = wa(t.value, e.quantity, e.flux);
    if ("why" in d) {
      n.value = d.why;
      return;
    }
    t.value = null, n.value = null, e.set(d.apply);
  }, s = (d) => {
    if (d.key === "Enter")
      d.preventDefault(), a(), t.value === null && o.current?.select();
    else if (d.key === "Escape")
      d.stopPropagation(), t.value === null && o.current?.blur(), t.value = null, n.value = null;
    else if ((d.key === "ArrowUp" || d.key === "ArrowDown") && e.step && t.value === null) {
      d.preventDefault();
      let m = (d.key === "ArrowUp" ? 1 : -1) * e.step * (d.shiftKey ? 10 : d.ctrlKey ? 0.1 : 1);
      e.set((f) => f + m);
    }
  }, p = (d) => {
    !e.scrub || e.disabled || d.button !== 0 || document.activeElement === o.current || (r.current = { x: d.clientX, last: d.clientX, moved: !1 }, o.current?.setPointerCapture(d.pointerId), d.preventDefault());
  }, c = (d) => {
    let m = r.current;
    !m || !e.scrub || !m.moved && Math.abs(d.clientX - m.x) < 4 || (m.moved || e.scrub.begin(), m.moved = !0, e.scrub.on((d.clientX - m.last) * (e.step ?? 1) * (d.shiftKey ? 0.1 : d.altKey ? 10 : 1)), m.last = d.clientX);
  }, u = (d) => {
    let m = r.current;
    r.current = null, m && (m.moved ? d.type === "pointercancel" ? e.scrub?.cancel() : e.scrub?.end() : (o.current?.focus(), o.current?.select()));
  };
  return l("span", { class: `field ${n.value ? "wrong" : ""} ${e.scrub ? "scrubs" : ""}`, children: [
    l(
      "input",
      {
        ref: o,
        id: e.id,
        tabIndex: e.tabIndex,
        type: "text",
        inputMode: "text",
        autoComplete: "off",
        spellcheck: !1,
        value: i,
        disabled: e.disabled,
        title: e.why ?? void 0,
        "aria-label": e.label,
        "aria-invalid": n.value ? !0 : void 0,
        "aria-errormessage": n.value ? `${e.id ?? e.label}-why`.replace(/\s/g, "-") : void 0,
        onInput: (d) => {
          t.value = d.currentTarget.value, n.value = null;
        },
        onFocus: (d) => t.value === null && d.currentTarget.select(),
        onBlur: () => {
          a(), n.value && (t.value = null, setTimeout(() => n.value = null, 4e3));
        },
        onKeyDown: s,
        onPointerDown: p,
        onPointerMove: c,
        onPointerUp: u,
        onPointerCancel: u
      }
    ),
    n.value && l("span", { class: "why", role: "alert", id: `${e.id ?? e.label}-why`.replace(/\s/g, "-"), children: n.value })
  ] });
}

// src/icon.tsx
function G({ name: e }) {
  return l("svg", { class: "sign", "aria-hidden": "true", width: "16", height: "16", children: l("use", { href: `icons.svg#${e}` }) });
}

// src/menu.tsx
function qt({ id: e, label: t, title: n, children: o }) {
  let r = (a) => {
    let s = document.getElementById(e), p = a.getBoundingClientRect();
    s?.style.setProperty("left", `${Math.max(8, Math.min(p.left, innerWidth - 296))}px`), s?.style.setProperty("top", `${p.bottom + 4}px`);
  };
  return l(X, { children: [
    l("button", { ...{ popovertarget: e }, title: n, "aria-label": n, "aria-haspopup": "true", onPointerDown: (a) => r(a.currentTarget), onFocus: (a) => r(a.currentTarget), children: t }),
    l("div", { id: e, popover: "auto", class: "menu", children: o })
  ] });
}
function Sr({ id: e, label: t }) {
  let n = _r(e), o = ha(e);
  return l(
    "button",
    {
      class: "item",
      "aria-disabled": n !== null,
      title: n ?? void 0,
      onClick: (r) => {
        r.currentTarget.closest("[popover]")?.hidePopover(), oe(e);
      },
      children: [
        l("span", { children: t ?? o?.label }),
        l("kbd", { children: o?.keys })
      ]
    }
  );
}

// src/bar.tsx
var ka = {
  clean: "nothing changed",
  saved: "saved",
  waiting: "saving…",
  failed: "not saved"
};
function xa() {
  let e = at.value, t = rt.value.undo, n = rt.value.redo, o = it.value, r = e.metered;
  return l("header", { class: "bar", children: [
    l(qt, { id: "page-menu", label: l(G, { name: "menu" }), title: "Page", children: l(ee, { part: "PageItems" }) }),
    l("h1", { title: o.file || Z.value?.file, children: [
      Z.value?.name ?? "Lampyris",
      l("i", { class: `dot ${o.state}`, role: "img", "aria-label": ka[o.state], title: `${ka[o.state]}${o.file ? `: ${o.file}` : ""}` })
    ] }),
    l("span", { class: "group", children: [
      l("button", { class: "icon", "aria-label": t ? `Undo: ${t}` : "Undo", title: t ? `Undo: ${t} (Ctrl+Z)` : "Nothing to undo", "aria-disabled": t === null, onClick: () => oe("undo"), children: l(G, { name: "undo" }) }),
      l("button", { class: "icon", "aria-label": n ? `Redo: ${n}` : "Redo", title: n ? `Redo: ${n} (Ctrl+Shift+Z)` : "Nothing to redo", "aria-disabled": n === null, onClick: () => oe("redo"), children: l(G, { name: "redo" }) })
    ] }),
    l(qt, { id: "view-menu", label: l(X, { children: [
      "View ",
      l(G, { name: "down" })
    ] }), title: "View", children: l(ee, { part: "ViewItems" }) }),
    l("span", { class: "group wide", children: [
      l("button", { "aria-pressed": !1, onClick: () => oe("preset-plan"), title: "Plan (Shift+1)", children: "Plan" }),
      l("button", { onClick: () => oe("inside"), title: "Inside (Shift+0)", children: "Inside" })
    ] }),
    l("span", { class: "gap" }),
    l(qt, { id: "seeing-menu", label: l(X, { children: [
      "Picture ",
      l(G, { name: "down" })
    ] }), title: "Picture: tone, white, figures", children: l(ee, { part: "SeeingItems" }) }),
    l("button", { "aria-pressed": e.false_color !== null, onClick: br, title: "False colour (B)", children: "False colour" }),
    l("button", { "aria-pressed": de.value === "wipe", "aria-disabled": pn.value === null, onClick: () => oe("wipe"), title: "Wipe between before and now (C); hold \\ to see before", children: "Compare" }),
    l("span", { class: "group exposure", role: "group", "aria-label": "Exposure", children: [
      l("button", { class: "icon", "aria-label": "Darker", title: "Darker by ⅓ (,)", onClick: () => so(1), children: l(G, { name: "minus" }) }),
      l("label", { children: [
        l("span", { "aria-hidden": "true", children: "EV" }),
        l(gn, { label: "Exposure value", quantity: "ev", value: e.ev ?? 0, step: 1 / 3, set: (i) => At({ ev: i(e.ev ?? 0) }) })
      ] }),
      l("button", { class: "icon", "aria-label": "Brighter", title: "Brighter by ⅓ (.)", onClick: () => so(-1), children: l(G, { name: "plus" }) }),
      l("button", { class: "icon", "aria-label": "Meter once", title: `${r ? "As metered" : "Meter once"} (/); it stays locked`, onClick: () => H({ do: "expose" }), children: l(G, { name: r ? "lock" : "meter" }) })
    ] }),
    l(
      "button",
      {
        class: "icon look-lock",
        "aria-pressed": ye.value,
        "aria-label": "Look-only lock",
        title: "Look-only lock: no finger changes anything",
        onClick: () => ye.value = !ye.value,
        children: l(G, { name: ye.value ? "lock" : "unlock" })
      }
    ),
    pe.value === "edit" && l("button", { class: "wide", onClick: () => pt.value = "share", children: "Share" }),
    l("button", { class: "icon", "aria-label": "All keys", title: "All keys (?)", onClick: () => pt.value = "help", children: l(G, { name: "help" }) }),
    l("button", { class: "icon", "aria-label": "Command palette", title: "Command palette (Ctrl+K)", onClick: () => pt.value = "palette", children: l(G, { name: "search" }) }),
    l(
      "button",
      {
        class: "icon narrow",
        "aria-label": Ie.value === "inspector" ? "Lamps" : "Inspector",
        title: Ie.value === "inspector" ? "Lamps" : "Inspector",
        onClick: () => Ie.value = Ie.value === "inspector" ? "lamps" : "inspector",
        children: l(G, { name: Ie.value === "inspector" ? "lamps" : "sliders" })
      }
    )
  ] });
}

// src/highlight.ts
function uo(e) {
  ke.value = e, H({ do: "solo", lamps: e });
}
function Mr(e) {
  let t = ke.peek(), n = e.every((o) => t.includes(o));
  uo(n ? t.filter((o) => !e.includes(o)) : [...t, ...e.filter((o) => !t.includes(o))]);
}
var bl = () => Mr(le.peek()), Cr = () => uo([]), bn = null;
function co(e) {
  e && bn === null && le.peek().length ? (bn = ke.peek(), uo(le.peek())) : !e && bn !== null && (uo(bn), bn = null);
}

// src/lights.ts
var Ye = g(null), Er = () => {
}, Ma = () => {
};
function fo(e, t, n) {
  po(), Ye.value = { x: e, y: t, hit: n, lux: n.lux, lamps: [], done: !1 }, Sa(n);
  let o = !0, r = 0;
  Ma = T(() => {
    for (let [, i] of M.all()) st(i);
    if (o) {
      o = !1;
      return;
    }
    clearTimeout(r), r = window.setTimeout(() => {
      let i = ie(() => Ye.value);
      i && Sa(i.hit);
    }, 250);
  });
}
function Sa(e) {
  Er(), Er = Se("light", { point: e.point, normal: e.normal }, (t) => {
    let n = Ye.peek();
    n && (Ye.value = {
      ...n,
      lux: t.lux ?? n.lux,
      lamps: t.lamps ?? n.lamps,
      done: t.done !== !1
    });
  });
}
function po() {
  Er(), Ma(), Ye.value = null;
}

// src/keys.ts
var Va = g("W A S D"), Tr = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyA: [0, -1, 0],
  KeyD: [0, 1, 0],
  KeyQ: [0, 0, -1],
  KeyE: [0, 0, 1]
}, yl = 1.8, jt = /* @__PURE__ */ new Set(), mo = !1, ho = 1, Pr = !1, $r = 0;
function Ia(e) {
  let t = Math.min(0.1, Math.max(0, (e - $r) / 1e3));
  if ($r = e, !jt.size) {
    Pr = !1;
    return;
  }
  let [n, o, r] = [0, 0, 0];
  for (let s of jt) {
    let [p, c, u] = Tr[s];
    n += p, o += c, r += u;
  }
  let i = Math.max(1, He(...Ot()) / 12), a = yl * t * ho * Math.min(i, 6);
  (n || o || r) && fa(n * a, o * a, r * a), requestAnimationFrame(Ia);
}
function yn(e) {
  jt.add(e), !Pr && (Pr = !0, $r = performance.now(), requestAnimationFrame(Ia));
}
var _l = (e) => e instanceof HTMLElement && (e.isContentEditable || e.matches("input, textarea, select") && !e.matches("[type=range], [type=checkbox], [type=radio]"));
function Ca() {
  let e = document.activeElement;
  return e === null || e === document.body || e.id === "view";
}
var wl = {
  f: "frame",
  t: "aim",
  g: "move",
  r: "turn",
  n: "add-spot",
  o: "on-off",
  i: "solo",
  h: "hide",
  b: "false-colour",
  u: "panels",
  c: "wipe",
  m: "marquee",
  v: "walking",
  p: "meter",
  "[": "previous",
  "]": "next",
  "?": "help",
  delete: "remove",
  home: "home"
}, Ea = {
  b: "quantity",
  o: "park",
  i: "unsolo",
  l: "from-lamp",
  g: "grid",
  t: "aim-here",
  n: "place"
}, Ta = { Comma: "darker", Period: "brighter", Slash: "expose" }, Pa = {
  Digit1: "preset-plan",
  Digit2: "preset-ceiling",
  Digit3: "preset-north",
  Digit4: "preset-east",
  Digit5: "preset-south",
  Digit6: "preset-west",
  Digit0: "inside"
};
function kl(e) {
  let t = e.key.toLowerCase();
  return t === "z" ? e.shiftKey ? "redo" : "undo" : t === "y" ? "redo" : t === "k" ? "palette" : t === "s" ? e.shiftKey ? "picture" : "save" : t === "d" ? "duplicate" : t === "a" ? "all-lamps" : t === "enter" ? "look-store" : null;
}
function xl() {
  z.peek() ? z.value = null : Ye.peek() ? po() : de.peek() ? de.value = null : P.peek() ? Zn() : document.activeElement?.id === "view" && document.querySelector('.bar button, .bar [tabindex="0"]')?.focus();
}
function $a(e) {
  let [t, n] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
  return !t && !n ? !1 : (e.ctrlKey || ne()?.height ? Ft(-t * 24, n * 24, 3) : e.shiftKey ? oo(Dt(), -t * 0.05, n * 0.05) : no(-t * 0.06, n * 0.06), !0);
}
function La(e) {
  let t = ne(), n = ft();
  !t || !n || (t.height ? Q(Fn(t, n, n.width / 2, n.height / 2, e)) : Q(Dn(t, t.target, e, 0.3, !0)));
}
function Sl(e) {
  if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
  let t = e.ctrlKey || e.metaKey;
  if (e.key === "Escape") return xl();
  if (_l(e.target)) {
    t && e.key.toLowerCase() === "k" && De(e, "palette");
    return;
  }
  if (t && !e.altKey) {
    if (Ca() && $a(e)) return e.preventDefault();
    let i = kl(e);
    i && De(e, i);
    return;
  }
  if (e.altKey) {
    let i = /^Digit(\d)$/.exec(e.code)?.[1];
    if (e.key === "ArrowLeft") return De(e, "back");
    if (e.key === "ArrowRight") return De(e, "forth");
    if (i === "0") return De(e, "store-view");
    if (i) {
      e.preventDefault();
      let a = St.all()[Number(i) - 1];
      a && Q(a[1], a[1].name ?? "view");
      return;
    }
    if (e.code === "KeyH" && De(e, "unhide"), !(e.code in Tr)) return;
  }
  let n = Ca();
  if (n && $a(e)) return e.preventDefault();
  if (n && e.code in Tr)
    return ho = e.shiftKey ? 4 : e.altKey ? 0.25 : 1, yn(e.code), e.preventDefault();
  if (n && (e.key === "+" || e.key === "=")) return La(0.85);
  if (n && (e.key === "-" || e.key === "_")) return La(1 / 0.85);
  if (!er.peek()) return;
  if (e.shiftKey && Pa[e.code]) return De(e, Pa[e.code]);
  if (mo && /^\d$/.test(e.key)) {
    e.preventDefault(), mo = !1;
    let i = Mt.ids.peek()[Number(e.key) - 1];
    i !== void 0 && ao({ do: "look", id: i, what: "recall", seconds: nr.peek() });
    return;
  }
  if (mo = e.key.toLowerCase() === "j", mo) return se("Recall a look: now its digit.");
  if (!e.shiftKey && /^\d$/.test(e.key) && le.peek().length) {
    e.preventDefault(), gr.value = e.key;
    return;
  }
  if (!e.shiftKey && e.key !== "?" && Ta[e.code]) return De(e, Ta[e.code]);
  if (e.key === "\\") return void (e.repeat || dn(!0));
  let o = e.key.toLowerCase();
  if (o === "l" && !e.shiftKey) return void (e.repeat || oe("highlight"));
  if (o === "p" && e.shiftKey) return Ml();
  let r = e.shiftKey && Ea[o] ? Ea[o] : wl[o];
  r && !(e.target instanceof HTMLButtonElement && o === "enter") && De(e, r);
}
function Ml() {
  let [e, t] = _e.peek(), n = Kt(e / 2, t / 2);
  n && Se("point", n, (o) => o.hit && fo(e / 2, t / 2, o));
}
function De(e, t) {
  e.preventDefault(), oe(t);
}
function Cl(e) {
  jt.delete(e.code), e.key === "\\" && dn(!1), e.key.toLowerCase() === "l" && co(!1), e.key === "Shift" && (ho = 1);
}
function Aa() {
  addEventListener("keydown", Sl), addEventListener("keyup", Cl), addEventListener("blur", () => {
    jt.clear(), co(!1), dn(!1);
  }), navigator.keyboard?.getLayoutMap().then((t) => {
    Va.value = ["KeyW", "KeyA", "KeyS", "KeyD"].map((n) => (t.get(n) ?? n.slice(3)).toUpperCase()).join(" ");
  }).catch(() => {
  });
}
function El(e, t) {
  for (let n of ["KeyW", "KeyS", "KeyA", "KeyD"]) jt.delete(n);
  ho = Math.min(1, Math.hypot(e, t)), e > 0.2 && yn("KeyW"), e < -0.2 && yn("KeyS"), t < -0.2 && yn("KeyA"), t > 0.2 && yn("KeyD");
}

// src/levels.ts
var Lr = (e) => Math.min(1, Yn.value === "square" ? Math.sqrt(Math.max(e, 0)) : e), Vr = (e) => {
  let t = Yn.peek() === "square" ? e * e : e;
  return Math.round(t * 1e3) / 1e3;
}, Tl = (e) => (e.kind === "lamp" ? M.get(e.id) : D.get(e.id))?.level ?? 0, vo = (e) => (e.kind === "lamp" ? M.get(e.id) : D.get(e.id))?.name ?? "";
function Ir(e) {
  let t = le.peek();
  return e.kind === "lamp" && P.peek()?.kind === "lamp" && t.length > 1 && t.includes(e.id) ? t : [e.id];
}
function Ra(e, t, n) {
  if (e.kind === "group") return { groups: { [e.id]: { level: t } } };
  let o = n.get(e.id) ?? 0, r = {};
  for (let [i, a] of n) {
    let s = i === e.id ? t : o > 0 ? Math.min(10, a * (t / o)) : t;
    r[i] = { level: Math.round(s * 1e3) / 1e3 };
  }
  return { lamps: r };
}
var _n = class {
  constructor(t) {
    this.strip = t;
    this.was = this.now = Tl(t), this.from = t.kind === "lamp" ? new Map(Ir(t).map((n) => [n, M.get(n)?.level ?? 0])) : /* @__PURE__ */ new Map(), this.gesture = new Be(`${vo(t)} level`);
  }
  strip;
  gesture;
  from;
  was;
  now;
  to(t) {
    this.now = t, this.gesture.set(Ra(this.strip, t, this.from));
  }
  end() {
    let t = this.from.size > 1 ? eo([...this.from.keys()]) : vo(this.strip);
    this.gesture.end(`${t} ${Ae(this.was)} → ${Ae(this.now)} %`);
  }
  cancel() {
    this.gesture.cancel();
  }
};
function go(e, t) {
  let n = new Map(Ir(e).map((o) => [o, M.get(o)?.level ?? 0]));
  rr(`level ${e.kind} ${e.id}`, `${vo(e)} level`, Ra(e, t, n));
}
function Ar(e, t) {
  if (!e.length) return;
  let n = Object.fromEntries(e.map((r) => {
    let i = M.get(r);
    return [r, { level: t(i?.level ?? 0, i?.flux ?? 1) }];
  })), o = e.length === 1 ? ` ${Ae(M.get(e[0])?.level ?? 0)} → ${Ae(n[e[0]].level)} %` : " level";
  Le(`${eo(e)}${o}`, { lamps: n });
}
function Rr(e, t) {
  let n = t(D.get(e)?.level ?? 0);
  Le(`${D.get(e)?.name ?? "Group"} ${Ae(n)} %`, { groups: { [e]: { level: n } } });
}
function Or(e, t) {
  let n = `${vo(e)} ${t ? "on" : "off"}`;
  e.kind === "group" ? Le(n, { groups: { [e.id]: { on: t } } }) : Le(n, { lamps: Object.fromEntries(Ir(e).map((o) => [o, { on: t }])) });
}

// src/swatch.ts
var Pl = (e) => e <= 31308e-7 ? 12.92 * e : 1.055 * e ** 0.4166666666666667 - 0.055, $l = (e) => e <= 0.04045 ? e / 12.92 : ((e + 0.055) / 1.055) ** 2.4, Ll = (e) => Math.round(255 * Pl(Math.max(0, Math.min(1, e))));
function Hr(e) {
  let t = Math.max(...e, 1e-6);
  return Oa(e.map((n) => n / t));
}
function Oa(e) {
  return `#${e.map((t) => Ll(t).toString(16).padStart(2, "0")).join("")}`;
}
function Vl(e) {
  let t = (n) => $l(parseInt(e.slice(1 + 2 * n, 3 + 2 * n), 16) / 255);
  return [t(0), t(1), t(2)];
}
var Il = (e) => 1e6 / e;

// src/range.tsx
var Ha = -1e9;
addEventListener("scroll", () => Ha = performance.now(), { capture: !0, passive: !0 });
var Ut = (e) => Math.max(0, Math.min(1, e));
function Kr(e) {
  let t = te(null), n = te(null), o = e.notch ?? 0.01, r = (c) => {
    if (c.button !== 0 || e.disabled) return;
    let u = c.currentTarget.getBoundingClientRect(), d = e.vertical ? (u.bottom - c.clientY - 8) / (u.height - 16) : (c.clientX - u.left - 6) / (u.width - 12), m = c.pointerType !== "touch" && !c.shiftKey;
    n.current = { id: c.pointerId, x: c.clientX, y: c.clientY, at: m ? Ut(d) : e.value }, t.current?.setPointerCapture(c.pointerId), t.current?.focus(), e.begin?.(), m && e.on(Ut(d));
  }, i = (c) => {
    let u = n.current;
    if (!u || u.id !== c.pointerId) return;
    let d = c.currentTarget.getBoundingClientRect(), m = e.vertical ? (u.y - c.clientY) / (d.height - 16) : (c.clientX - u.x) / (d.width - 12);
    u.x = c.clientX, u.y = c.clientY, u.at += m * (c.shiftKey ? 0.1 : 1), e.on(Ut(u.at));
  }, a = (c) => {
    n.current?.id === c.pointerId && (n.current = null, c.type === "pointercancel" ? e.cancel?.() : e.end?.());
  }, s = (c) => {
    if (c.key === "Escape" && n.current) {
      n.current = null, e.cancel?.(), c.stopPropagation();
      return;
    }
    let u = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[c.key], d = null;
    u && (d = Ut(e.value + u * o * (c.shiftKey ? 10 : 1))), c.key === "Home" && (d = 0), c.key === "End" && (d = 1), !(d === null || c.altKey || c.ctrlKey || c.metaKey) && (c.preventDefault(), c.stopPropagation(), e.on(d));
  }, p = (c) => {
    if (performance.now() - Ha < 400 || c.ctrlKey) return;
    c.preventDefault();
    let u = Math.abs(c.deltaY) >= Math.abs(c.deltaX) ? c.deltaY : c.deltaX;
    u && e.on(Ut(e.value - Math.sign(u) * o * (c.shiftKey ? 0.2 : 1)));
  };
  return l(
    "input",
    {
      ref: t,
      type: "range",
      id: e.id,
      class: `range ${e.class ?? ""} ${e.vertical ? "upright" : ""}`,
      min: 0,
      max: 1,
      step: "any",
      value: e.value,
      disabled: e.disabled,
      "aria-label": e.label,
      "aria-valuetext": e.text,
      style: { "--t": Ut(e.value), "--gradient": e.gradient ?? "" },
      onPointerDown: r,
      onPointerMove: i,
      onPointerUp: a,
      onPointerCancel: a,
      onMouseDown: (c) => c.preventDefault(),
      onTouchStart: (c) => c.cancelable && c.preventDefault(),
      onKeyDown: s,
      onWheel: p,
      onDblClick: () => e.reset?.(),
      onInput: (c) => {
        n.current ? c.currentTarget.value = String(e.value) : e.on(Number(c.currentTarget.value));
      }
    }
  );
}

// src/faderrow.tsx
function Ka(e) {
  let t = e.color;
  return t.mode === "kelvin" ? `${B(t.kelvin)} K` : t.mode === "rgb" ? "RGB" : t.mode === "xy" ? "x y" : "file";
}
var Dr = (e) => e.free ? "re-mix: level and colour cost no ray" : "re-trace: its light is traced anew";
function Da({ row: e, index: t, count: n }) {
  let o = te(null), r = { kind: e.kind, id: e.id }, i = e.kind === "lamp" ? M.get(e.id) : void 0, a = e.kind === "group" ? D.get(e.id) : void 0, s = i ?? a;
  if (!s) return null;
  let p = a?.lamps ?? [e.id], c = i ? i.flux : p.reduce((_, C) => _ + (M.get(C)?.flux ?? 0) * (M.get(C)?.level ?? 0), 0), u = Uo(p), d = P.value?.kind === e.kind && P.value.ids.includes(e.id), m = p.length > 0 && p.every((_) => ke.value.includes(_)), f = ke.value.length > 0 && !p.some((_) => ke.value.includes(_)), b = me.value?.kind === e.kind && me.value.id === e.id, y = `${d ? "selected" : ""} ${s.on && !i?.parked ? "" : "off"} ${f ? "muted" : ""} ${b ? "under" : ""}`, w = Qn.value, x = d ? 0 : -1, k = {
    begin: () => o.current = new _n(r),
    end: () => {
      o.current?.end(), o.current = null;
    },
    cancel: () => {
      o.current?.cancel(), o.current = null;
    }
  };
  return l(
    "div",
    {
      class: `fader-row depth-${e.depth} ${e.kind} ${y}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => me.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => me.value = null,
      children: [
        l("button", { class: "icon power", tabIndex: x, "aria-pressed": s.on, disabled: w !== null, "aria-label": `${s.name} on`, title: w ?? (s.on ? "On (O)" : "Off (O)"), onClick: () => Or(r, !s.on), children: l(G, { name: "power" }) }),
        l("div", { class: "top", children: [
          a && l("button", { class: "icon fold", "aria-expanded": !mt.value.has(e.id), "aria-label": `Members of ${s.name}`, onClick: () => Fa(e.id), children: l(G, { name: mt.value.has(e.id) ? "right" : "down" }) }),
          l("button", { class: "row-name", "aria-pressed": d, title: i ? `${i.name}: ${Dr(i)}` : s.name, onClick: (_) => Fr(_, e.kind, e.id), children: [
            l("span", { children: s.name }),
            a && l("small", { children: p.length }),
            i?.parked && l("small", { children: "parked" }),
            i && !i.free && l("small", { class: "traced", title: Dr(i), children: [
              "↻",
              l("span", { class: "spoken", children: "re-trace" })
            ] })
          ] }),
          i && l("span", { class: "tint", children: [
            l("i", { class: "swatch", style: { background: Hr(i.swatch) } }),
            Ka(i)
          ] }),
          l("button", { class: "icon solo", tabIndex: x, "aria-pressed": m, "aria-label": `Solo ${s.name}`, title: "Solo (I)", onClick: () => Mr(p), children: l(G, { name: "solo" }) })
        ] }),
        l("div", { class: "bottom", children: [
          l(
            Kr,
            {
              label: `${s.name} level`,
              class: "level",
              value: Lr(s.level),
              text: `${Ae(s.level)} %, ${Xe(u)} lumen`,
              notch: 0.01,
              disabled: w !== null,
              on: (_) => {
                let C = Vr(_);
                o.current ? o.current.to(C) : go(r, C);
              },
              reset: () => go(r, 1),
              ...k
            }
          ),
          l(
            gn,
            {
              label: `${s.name} level, typed`,
              quantity: "level",
              value: s.level,
              flux: c,
              step: 0.01,
              disabled: w !== null,
              why: w,
              tabIndex: x,
              set: (_) => i ? Ar(d && le.peek().length > 1 ? le.peek() : [e.id], _) : Rr(e.id, _)
            }
          ),
          l("span", { class: "lumens", children: vn(u, "flux") })
        ] })
      ]
    }
  );
}

// src/virtual.tsx
var Na = 4;
function Nr({ count: e, height: t, row: n, label: o, show: r, role: i = "list" }) {
  let a = te(null), s = nt(0), p = nt(600);
  Ce(() => {
    let d = a.current, m = new ResizeObserver(() => p.value = d.clientHeight);
    return m.observe(d), () => m.disconnect();
  }, []), Ce(() => {
    let d = a.current;
    if (!d || r === void 0 || r < 0) return;
    let m = r * t;
    (m < d.scrollTop || m + t > d.scrollTop + d.clientHeight) && (d.scrollTop = Math.max(0, m - d.clientHeight / 2));
  }, [r, t]);
  let c = Math.max(0, Math.floor(s.value / t) - Na), u = Math.min(e, Math.ceil((s.value + p.value) / t) + Na);
  return l("div", { class: "virtual", ref: a, tabIndex: e ? void 0 : -1, onScroll: (d) => s.value = d.currentTarget.scrollTop, children: l("div", { class: "all", role: i, "aria-label": o, style: { height: `${e * t}px` }, children: l("div", { class: "rows", role: "presentation", style: { transform: `translateY(${c * t}px)` }, children: Array.from({ length: Math.max(0, u - c) }, (d, m) => n(c + m)) }) }) });
}

// src/lamps.tsx
var bo = g(""), mt = g(/* @__PURE__ */ new Set()), yo = g("group"), ja = N(() => {
  let e = bo.value.trim().toLowerCase(), t = M.listed(), n = D.listed(), o = new Map(n.map(([s, p]) => [s, p.name])), r = new Map(t.filter(([, s]) => !e || `${s.name} ${s.kind} ${o.get(s.group ?? -1) ?? ""}`.toLowerCase().includes(e)));
  if (yo.value !== "group" && Lt.value === "sheet") {
    let s = yo.value, p = [...r];
    return p.sort(([, c], [, u]) => s === "name" ? c.name.localeCompare(u.name, "en", { numeric: !0 }) : u[s] - c[s]), p.map(([c]) => ({ kind: "lamp", id: c, depth: 0 }));
  }
  let i = [], a = /* @__PURE__ */ new Set();
  for (let [s, p] of n) {
    p.lamps.forEach((u) => a.add(u));
    let c = p.lamps.filter((u) => r.has(u));
    if (c.length) {
      if (p.lamps.length === 1) {
        i.push({ kind: "lamp", id: c[0], depth: 0 });
        continue;
      }
      i.push({ kind: "group", id: s, depth: 0 }), (!mt.value.has(s) || e) && c.forEach((u) => i.push({ kind: "lamp", id: u, depth: 1 }));
    }
  }
  for (let [s] of r) a.has(s) || i.push({ kind: "lamp", id: s, depth: 0 });
  return i;
}), qa = !1;
D.ids.subscribe((e) => {
  qa || !e.length || (qa = !0, M.ids.peek().length > 40 && (mt.value = new Set(e.filter((t) => (D.get(t)?.lamps.length ?? 0) > 1))));
});
function Fa(e) {
  let t = new Set(mt.peek());
  t.delete(e) || t.add(e), mt.value = t;
}
function Fr(e, t, n) {
  e.shiftKey ? ia(t, ja.peek().filter((o) => o.kind === t).map((o) => o.id), n) : ze(t, n, e.ctrlKey || e.metaKey ? "toggle" : "only");
}
function Al(e) {
  let t = { ArrowDown: 1, ArrowUp: -1 }[e.key], n = e.target;
  if (!t || !n.matches(".row-name")) return;
  e.preventDefault();
  let o = [...e.currentTarget.querySelectorAll(".row-name")];
  o[o.indexOf(n) + t]?.focus();
}
var Rl = ["add-spot", "add-point", "add-disc", "add-sphere"];
function Ua() {
  let e = ja.value, t = P.value?.ids[P.value.ids.length - 1], n = e.findIndex((i) => i.kind === P.value?.kind && i.id === t), o = matchMedia("(pointer: coarse)").matches, r = Lt.value === "sheet";
  return l("section", { class: "panel lamps", "aria-label": "Lamps", onKeyDown: Al, children: [
    l("header", { class: "panel-head", children: [
      l("h2", { children: [
        "Lamps ",
        l("small", { children: B(M.ids.value.length) })
      ] }),
      l("span", { class: "gap" }),
      l("div", { class: "segments", role: "group", "aria-label": "Listing", children: [
        l("button", { "aria-pressed": !r, onClick: () => Lt.value = "faders", children: "Faders" }),
        l("button", { "aria-pressed": r, onClick: () => Lt.value = "sheet", children: "Sheet" })
      ] })
    ] }),
    l("div", { class: "panel-tools", children: [
      l("span", { class: "field filter", children: l(
        "input",
        {
          type: "text",
          "aria-label": "Filter lamps",
          placeholder: "Filter",
          value: bo.value,
          onInput: (i) => bo.value = i.currentTarget.value,
          onKeyDown: (i) => {
            i.key === "Escape" && (bo.value = "", i.stopPropagation());
          }
        }
      ) }),
      r && l("select", { "aria-label": "Order", value: yo.value, onChange: (i) => yo.value = i.currentTarget.value, children: [
        l("option", { value: "group", children: "by group" }),
        l("option", { value: "name", children: "by name" }),
        l("option", { value: "flux", children: "by flux" }),
        l("option", { value: "level", children: "by level" })
      ] }),
      l(qt, { id: "add-menu", label: "Add", title: "Add a lamp", children: [
        Rl.map((i) => l(Sr, { id: i }, i)),
        l("button", { class: "item", "aria-disabled": "true", title: "Photometric files come with a later version", children: [
          l("span", { children: "IES or LDT file…" }),
          l("kbd", { children: "later" })
        ] })
      ] })
    ] }),
    r && l(ee, { part: "SheetHead" }),
    l(
      Nr,
      {
        label: "Lamps and groups",
        count: e.length,
        height: r ? o ? 44 : 28 : o ? 84 : 54,
        show: n,
        row: (i) => {
          let a = e[i], s = r ? kr("SheetRow") : Da;
          return s && l(s, { row: a, index: i, count: e.length }, `${a.kind}${a.id}`);
        }
      }
    ),
    le.value.length > 1 && l("p", { class: "several", children: [
      le.value.length,
      " selected; a fader moves them in proportion",
      l("button", { onClick: () => oe("none"), children: "None" })
    ] }),
    !e.length && M.ids.value.length > 0 && l("p", { class: "quiet empty", children: "No lamp is called so." })
  ] });
}

// src/states.ts
var kn = g(null), Qe = g([]), xn = g(null), jr = g(null), qr = N(() => Te.value?.stage ?? "loading"), Wa = g(!1), wn = 0;
T(() => {
  let e = Te.value?.fps ?? 0;
  qr.value === "moving" && e > 6 && $t.value < 0.4 * e && $t.value < 5 ? wn || (wn = performance.now()) : wn = 0, Wa.value = wn > 0 && performance.now() - wn > 2e3;
});
var Wt = N(() => {
  switch (U.value) {
    case "entering":
      return "starting";
    case "open":
      break;
    default:
      return U.value;
  }
  return !Z.value || !W.value ? "loading" : it.value.state === "failed" ? "unsaved" : kn.value !== null ? "broken" : xn.value !== null && !F.value.you ? "control-lost" : pe.value === "watch" || !F.value.you ? "watching" : M.ids.value.length === 0 ? "no-lamps" : Ui.value ? "all-off" : Wa.value ? "slow" : qr.value === "loading" ? "first" : qr.value;
});
xe("event", (e) => {
  switch (e.what) {
    case "reloaded": {
      kn.value = null, Qe.value = e.lost ?? [];
      let t = e.kept ?? 0;
      se(`The scene was read again: ${t} edits kept${Qe.value.length ? `, ${Qe.value.length} no longer find what they changed` : ""}.`);
      break;
    }
    case "broken":
      kn.value = e.why ?? "The scene file cannot be read.";
      break;
    case "taken":
      xn.value = e.by ?? F.peek().name ?? "somebody else";
      break;
    case "loading":
      jr.value = e;
      break;
  }
});
xe("refused", (e) => se(e.why ?? "That could not be done.", "warn"));
T(() => {
  F.value.you && (xn.value = null);
});

// src/probe.ts
var _o = g(null);
function wo(e, t, n) {
  let o = Kt(e, t);
  if (!o) return n(null);
  Se("point", o, (r) => n(r.hit ? r : null));
}
function Ba(e) {
  if (!e) return "";
  let t = [], n = M.get(e.lamp)?.name, o = be.get(e.thing)?.name, r = xt.get(e.material)?.name;
  if (n && t.push(n), o && o !== n && t.push(o), r && r !== o && t.push(r), e.lux && t.push(`${dt(e.lux[0])} ±${dt(e.lux[1], !1)}`), e.luminance) {
    let i = e.luminance[0] * (Vt.value === "fc" ? 0.2919 : 1);
    t.push(`${Xe(i)} ${Vt.value === "fc" ? "fL" : "cd/m²"}`);
  }
  return t.join(" · ");
}

// src/status.tsx
var za = N(() => {
  W.value;
  let e = [];
  for (let t of ae.sent.slice(-24)) {
    if (t.what !== "set" && t.what !== "camera") continue;
    let n = ae.frames.find((o) => o.seq >= t.seq && o.painted);
    n && n.painted > t.at && e.push(n.painted - (t.input || t.at));
  }
  return e.sort((t, n) => t - n), e.length ? e[e.length >> 1] : null;
});
function Ol() {
  let e = Te.value;
  if (!e) return "starting";
  let t = e.error == null ? "" : ` ±${B((e.error ?? 0) * 100, e.error < 0.0995 ? 1 : 0)} %`;
  switch (e.stage) {
    case "loading":
      return "first look";
    case "moving":
      return `moving${t}`;
    case "refining":
      return `${t.trim() || "refining"}${e.good_in ? `, good in ${B(e.good_in, e.good_in < 3 ? 1 : 0)} s` : ""}`;
    case "good":
      return `good${t}`;
    case "done":
      return `finished${t}`;
  }
}
function Ga() {
  let e = Te.value, t = W.value?.head, n = sn.value.filter((r) => r.batches < r.of && !r.held).length, o = e?.stage === "refining" && e.good_in ? Math.max(0.02, 1 / (1 + e.good_in)) : e?.stage === "good" || e?.stage === "done" ? 1 : 0.02;
  return l("footer", { class: "status", "aria-label": "Status", children: [
    l("span", { class: `quality ${e?.stage ?? ""}`, children: [
      l("i", { class: "thin", "aria-hidden": "true", children: l("b", { style: { width: `${o * 100}%` } }) }),
      Ol()
    ] }),
    l("span", { children: [
      B(t?.batches ?? e?.batches ?? 0),
      " batches"
    ] }),
    l("span", { children: U.value === "open" ? `${B($t.value)} fps` : "no line" }),
    za.value !== null && l("span", { title: "From the hand to the paint, median", children: [
      B(za.value),
      " ms"
    ] }),
    t && l("span", { children: [
      t.width,
      " × ",
      t.height
    ] }),
    l("span", { class: "wide", children: [
      sn.value.length,
      " layers",
      n ? `, ${n} tracing` : ""
    ] }),
    l("span", { class: "probe", "aria-live": "off", children: Ba(_o.value) }),
    l("span", { class: "gap" }),
    l("span", { children: F.value.you ? "editing: you" : `editing: ${F.value.name ?? "somebody else"}` }),
    l("span", { class: "spoken", children: [
      Wn.value ?? "",
      " ",
      Wt.value
    ] })
  ] });
}

// src/pointer.ts
var Hl = 4, Xa = 35e-4, Kl = 0.15;
function Dl(e, t, n) {
  return e === "maya" && n.alt ? ["orbit", "pan", "dolly"][t] ?? "none" : e === "blender" && t === 1 ? n.shift ? "pan" : n.ctrl ? "dolly" : "orbit" : t === 1 ? n.shift ? "pan" : "orbit" : t === 2 ? "look" : t === 0 ? n.alt ? "orbit" : n.space ? "pan" : n.shift || n.ctrl ? "none" : "look" : "none";
}
function Ya(e, t) {
  let n = /* @__PURE__ */ new Map(), o = Dt(), r = 3, i = !1, a = 0, s = 0, p = 0, c = null, u = (h) => {
    let v = e.getBoundingClientRect();
    return [h.clientX - v.left, h.clientY - v.top];
  }, d = (h, v, $) => {
    let L = Kt(h, v);
    L && Se("point", L, (V) => {
      let A = V;
      A.hit && $?.(A);
    });
  }, m = (h) => {
    let v = ft();
    return v ? Math.max(0.2, q(K(h, v.eye), v.forward)) : r;
  };
  function f(h) {
    if (h.target.closest("[data-handle]")) return;
    e.focus({ preventScroll: !0 });
    let [v, $] = u(h), L = h.pointerType === "touch", V = { alt: h.altKey, shift: h.shiftKey, ctrl: h.ctrlKey || h.metaKey, space: i }, A = L ? "look" : Dl(Xn.peek(), h.button, V);
    A === "look" && ne()?.height && (A = "pan"), z.peek() === "marquee" && h.button === 0 && (A = "none"), n.set(h.pointerId, {
      id: h.pointerId,
      button: h.button,
      x: v,
      y: $,
      startX: v,
      startY: $,
      moved: !1,
      motion: A,
      touch: L,
      shift: h.shiftKey,
      ctrl: V.ctrl
    }), e.setPointerCapture(h.pointerId), clearTimeout(a), t.unhover(), (A === "orbit" || A === "pan" || A === "dolly") && (o = Dt(), r = m(o), d(v, $, (R) => {
      o = R.point, r = m(R.point);
    })), clearTimeout(s), L && n.size === 1 && (s = window.setTimeout(() => {
      let R = n.get(h.pointerId);
      R && !R.moved && n.size === 1 && (R.moved = !0, R.motion = "none", t.menu(R.x, R.y));
    }, 550)), n.size === 2 && (c = b()), h.button === 1 && h.preventDefault();
  }
  function b() {
    let [h, v] = [...n.values()];
    return { gap: Math.hypot(h.x - v.x, h.y - v.y), x: (h.x + v.x) / 2, y: (h.y + v.y) / 2 };
  }
  function y(h) {
    let v = n.get(h.pointerId), [$, L] = u(h);
    if (!v) {
      if (h.pointerType === "touch" || h.buttons) return;
      t.unhover(), clearTimeout(a), a = window.setTimeout(() => t.hover($, L), 150);
      return;
    }
    let [V, A] = [$ - v.x, L - v.y];
    if (!(!v.moved && Math.hypot($ - v.startX, L - v.startY) < Hl)) {
      if (v.moved = !0, v.x = $, v.y = L, n.size === 2 && c) {
        let R = b();
        Ft(R.x - c.x, R.y - c.y, r), R.gap > 8 && c.gap > 8 && k(R.x, R.y, c.gap / R.gap, !1), c = R;
        return;
      }
      if (z.peek() === "marquee" && v.button === 0) {
        t.marquee([v.startX, v.startY], [$, L], !1);
        return;
      }
      switch (v.motion) {
        case "look": {
          let R = v.touch ? 1 : -1;
          no(R * V * Xa, R * A * Xa);
          break;
        }
        case "orbit":
          oo(o, -V * 6e-3, -A * 6e-3);
          break;
        case "pan":
          Ft(V, A, r);
          break;
        case "dolly":
          k(v.startX, v.startY, Math.exp(A * 6e-3), !1);
          break;
        case "none":
          break;
      }
    }
  }
  function w(h) {
    let v = n.get(h.pointerId);
    if (n.delete(h.pointerId), clearTimeout(s), n.size < 2 && (c = null), !(!v || h.type === "pointercancel")) {
      if (v.moved) {
        z.peek() === "marquee" && t.marquee([v.startX, v.startY], [v.x, v.y], !0);
        return;
      }
      if (v.touch) {
        let $ = performance.now(), L = $ - p < 320;
        if (p = $, L) return t.double();
        if (ye.peek()) return;
      }
      if (v.button === 2) t.menu(v.x, v.y);
      else if (v.button === 0) {
        let $ = v.shift ? "add" : v.ctrl ? "toggle" : "only";
        t.click(v.x, v.y, $);
      }
    }
  }
  let x = null;
  function k(h, v, $, L) {
    let V = ne(), A = ft();
    if (!V || !A) return;
    if (V.height) return Q(Fn(V, A, h, v, $));
    let R = performance.now();
    if (!x || R - x.time > 500 || Math.hypot(h - x.x, v - x.y) > 6) {
      x = { x: h, y: v, time: R, point: null };
      let vt = x;
      d(h, v, (Xr) => {
        vt.point = Xr.point, r = m(Xr.point);
      });
    }
    x.time = R;
    let [is, as] = [h - A.width / 2, A.height / 2 - v], ss = Math.min(r, He(V.eye, Dt()) + 1), ko = (vt) => V.eye[vt] + (A.forward[vt] + A.side[vt] * is * A.pixel + A.up[vt] * as * A.pixel) * ss, Gr = x.point ?? [ko(0), ko(1), ko(2)];
    Q(Dn(V, Gr, $, Kl, L)), L && He(V.eye, Gr) < 0.5 && (x = null);
  }
  function _(h) {
    if (h.target.closest("[data-scroll]")) return;
    h.preventDefault();
    let v = h.deltaMode === 1 ? 18 : h.deltaMode === 2 ? 400 : 1, [$, L] = [h.deltaX * v, h.deltaY * v], [V, A] = u(h);
    if (Xn.peek() === "trackpad" && !h.ctrlKey) return Ft(-$, -L, r);
    let R = (h.ctrlKey ? 6 : 1) * (Math.abs(L) > Math.abs($) ? L : $);
    k(V, A, Math.exp(Math.max(-300, Math.min(300, R)) * 16e-4), h.shiftKey && !h.ctrlKey);
  }
  let C = (h) => h.preventDefault(), Me = () => {
    clearTimeout(a), t.unhover();
  }, Je = (h) => {
    !h.target.closest("[data-handle]") && z.peek() === null && t.double();
  }, fe = (h) => {
    h.code === "Space" && (i = h.type === "keydown");
  }, ve = new ResizeObserver(() => {
    let h = e.getBoundingClientRect();
    _e.value = [Math.max(16, Math.round(h.width)), Math.max(16, Math.round(h.height))];
  });
  return ve.observe(e), e.addEventListener("pointerdown", f), e.addEventListener("pointermove", y), e.addEventListener("pointerup", w), e.addEventListener("pointercancel", w), e.addEventListener("pointerleave", Me), e.addEventListener("wheel", _, { passive: !1 }), e.addEventListener("contextmenu", C), e.addEventListener("dblclick", Je), addEventListener("keydown", fe), addEventListener("keyup", fe), () => {
    ve.disconnect(), removeEventListener("keydown", fe), removeEventListener("keyup", fe);
  };
}

// src/overlay.ts
var Fl = "http://www.w3.org/2000/svg";
function we(e, t = {}, n) {
  let o = document.createElementNS(Fl, e);
  for (let [r, i] of Object.entries(t)) o.setAttribute(r, String(i));
  return n?.append(o), o;
}
var Wr = class {
  view;
  fit;
  constructor(t) {
    this.view = t, this.fit = hn(t.width, t.height);
  }
  at(t) {
    let [n, o, r] = tn(this.view, t);
    return r < 0.02 && !this.view.parallel ? null : [this.fit.x + n * this.fit.scale, this.fit.y + o * this.fit.scale];
  }
  /** A line of the scene as a path, as much of it as lies before the eye. */
  line(t, n) {
    let [, , o] = tn(this.view, t), [, , r] = tn(this.view, n), i = 0.05, [a, s] = [t, n];
    if (!this.view.parallel) {
      if (o < i && r < i) return "";
      let u = (i - o) / (r - o), d = I(S(t, 1 - u), S(n, u));
      o < i && (a = d), r < i && (s = d);
    }
    let [p, c] = [this.at(a), this.at(s)];
    return !p || !c ? "" : `M${p[0].toFixed(1)} ${p[1].toFixed(1)}L${c[0].toFixed(1)} ${c[1].toFixed(1)}`;
  }
};
function Br() {
  let e = W.value;
  return _e.value, e ? new Wr(wt(e.camera, e.head.width, e.head.height)) : null;
}
function Qa() {
  let e = ie(Br);
  return e ? M.all().flatMap(([t, n]) => {
    let o = Ja(n), r = o && e.at(o);
    return r ? [{ id: t, at: r }] : [];
  }) : null;
}
var Ja = hr, Nl = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
function Ur(e, t) {
  let n = _t(t);
  return Nl.map(([o, r]) => e.line(n[o], n[r])).join("");
}
var ql = 150, Sn = class {
  constructor(t, n, o) {
    this.parent = t;
    this.kind = n;
    this.shape = o;
  }
  parent;
  kind;
  shape;
  marks = /* @__PURE__ */ new Map();
  draw(t) {
    let n = /* @__PURE__ */ new Set();
    for (let { id: o, at: r, label: i, state: a } of t) {
      n.add(o);
      let s = this.marks.get(o);
      if (!s) {
        let p = we("g", { "data-kind": this.kind, "data-id": o }, this.parent);
        this.shape(p);
        let c = we("text", { x: 10, y: 4 }, p);
        s = { group: p, label: c }, this.marks.set(o, s);
      }
      if (!r) {
        s.group.setAttribute("display", "none");
        continue;
      }
      s.group.removeAttribute("display"), s.group.setAttribute("transform", `translate(${r[0].toFixed(1)} ${r[1].toFixed(1)})`), s.group.setAttribute("class", `mark ${this.kind} ${a}`), s.label.textContent !== i && (s.label.textContent = i);
    }
    for (let [o, r] of this.marks)
      n.has(o) || (r.group.remove(), this.marks.delete(o));
  }
};
function Za(e) {
  let t = we("path", { class: "aims" }, e), n = we("path", { class: "boxes" }, e), o = we("path", { class: "boxes hover" }, e), r = we("path", { class: "grid-lines" }, e), i = new Sn(we("g", {}, e), "lamp", (u) => we("circle", { r: 4.5 }, u)), a = new Sn(we("g", {}, e), "grid", () => {
  }), s = new Sn(we("g", {}, e), "meter", (u) => {
    we("circle", { r: 5.5 }, u), we("path", { d: "M-9 0H9M0 -9V9" }, u);
  }), p = T(() => {
    let u = Br();
    if (!u) return;
    let d = P.value, m = me.value, f = "", b = "", y = M.ids.value.length <= ql, w = M.all().map(([k, _]) => {
      let C = d?.kind === "lamp" ? d.ids.includes(k) : d?.kind === "group" && d.ids.includes(_.group ?? -1), Me = m?.kind === "lamp" ? m.id === k : m?.kind === "group" && m.id === _.group, Je = Ja(_), fe = _.place?.position;
      if (C && _.box && (b += Ur(u, _.box)), fe && _.place?.direction && (C || Me)) {
        let v = _.place.aim ?? I(fe, _.place.direction);
        f += u.line(fe, v);
      }
      let ve = C || Me || y && tr.value && (_.own || _.place?.position), h = `${C ? "selected" : ""} ${Me ? "under" : ""} ${st(_) ? "" : "off"}`;
      return { id: k, at: Je && ve ? u.at(Je) : null, label: C || Me ? _.name : "", state: h };
    });
    if (i.draw(w), t.setAttribute("d", f), d?.kind === "thing")
      for (let k of d.ids) {
        let _ = be.get(k)?.box;
        _ && (b += Ur(u, _));
      }
    n.setAttribute("d", b);
    let x = m?.kind === "lamp" ? M.get(m.id)?.box : m?.kind === "thing" ? be.get(m.id)?.box : null;
    o.setAttribute("d", x ? Ur(u, x) : "");
  }), c = T(() => {
    let u = Br();
    if (!u) return;
    let d = P.value, m = (b, y) => d?.kind === b && d.ids.includes(y) ? "selected" : "";
    s.draw(Ct.all().map(([b, y]) => ({
      id: b,
      at: u.at(y.point),
      label: y.lux ? dt(y.lux[0]) : "…",
      state: m("meter", b)
    })));
    let f = "";
    a.draw(qn.all().map(([b, y]) => {
      f += jl(u, y);
      let w = y.mean == null ? "…" : `${y.name} ${dt(y.mean)}`;
      return { id: b, at: u.at(y.corner), label: w, state: m("grid", b) };
    })), r.setAttribute("d", f);
  });
  return () => {
    p(), c(), e.replaceChildren();
  };
}
function jl(e, t) {
  let n = (r, i) => I(t.corner, I(S(t.u, r), S(t.v, i))), o = e.line(n(0, 0), n(1, 0)) + e.line(n(1, 0), n(1, 1)) + e.line(n(1, 1), n(0, 1)) + e.line(n(0, 1), n(0, 0));
  for (let r = 0; r < t.rows; r++)
    for (let i = 0; i < t.columns; i++) {
      let a = e.at(n((i + 0.5) / t.columns, (r + 0.5) / t.rows));
      a && (o += `M${(a[0] - 2).toFixed(1)} ${a[1].toFixed(1)}h4m-2 -2v4`);
    }
  return o;
}

// src/banner.tsx
function ce({ tone: e, children: t }) {
  return l("div", { class: `banner ${e}`, role: e === "warn" ? "alert" : "status", children: t });
}
var es = () => `lampyris view ${Z.peek()?.file ?? "SCENE"} --port ${location.port || 80}`;
function Ul() {
  let e = M.all().filter(([, n]) => !n.on || n.level === 0 || n.parked), t = D.all().filter(([, n]) => !n.on || n.level === 0);
  Le("All lamps on", {
    lamps: Object.fromEntries(e.map(([n, o]) => [n, { on: !0, parked: !1, ...o.level === 0 ? { level: 1 } : {} }])),
    groups: Object.fromEntries(t.map(([n, o]) => [n, { on: !0, ...o.level === 0 ? { level: 1 } : {} }]))
  });
}
function Wl() {
  switch (Wt.value) {
    case "starting":
      return l(ce, { tone: "calm", children: "Entering…" });
    case "loading": {
      let e = jr.value;
      return l(ce, { tone: "calm", children: [
        "Reading ",
        e?.file ?? Z.value?.file ?? "the scene",
        "…",
        e?.bytes ? ` ${B(e.bytes / 1e6, 1)} MB` : "",
        e?.progress != null && l("progress", { value: e.progress, max: 1, "aria-label": "Reading" })
      ] });
    }
    case "lost":
      return l(ce, { tone: "warn", children: [
        "Connection lost, trying again",
        cn.value ? ` (${cn.value} s)` : "…",
        ". Until then nothing can be changed."
      ] });
    case "ended":
      return l(ce, { tone: "warn", children: [
        l("span", { children: [
          "The program has ended. Start it again with ",
          l("code", { children: es() }),
          ": this page comes back by itself."
        ] }),
        l("button", { onClick: () => {
          yr(es());
        }, children: "Copy" })
      ] });
    case "denied":
      return l(ce, { tone: "warn", children: "This link is not valid (any more). Open the one that the program has printed, or ask for a new one." });
    case "renewed":
      return l(ce, { tone: "warn", children: [
        "New version. ",
        l("button", { onClick: () => location.reload(), children: "Reload" })
      ] });
    case "unsaved":
      return l(ce, { tone: "warn", children: [
        "Edits are not being saved: ",
        it.value.why ?? "unknown reason",
        ".",
        l("button", { onClick: () => pt.value = "save", children: "Save elsewhere" })
      ] });
    case "broken":
      return l(ce, { tone: "warn", children: [
        kn.value,
        " Still showing what was read before."
      ] });
    case "control-lost":
      return l(ce, { tone: "warn", children: [
        l("span", { children: [
          "Control moved to ",
          l("em", { children: xn.value }),
          "."
        ] }),
        " ",
        l("button", { onClick: () => H({ do: "edit", what: "take" }), children: "Take it back" })
      ] });
    case "watching":
      return l(ce, { tone: "calm", children: [
        l("span", { children: [
          "You are watching",
          F.value.name ? l(X, { children: [
            "; ",
            l("em", { children: F.value.name }),
            " edits"
          ] }) : "",
          "."
        ] }),
        l("button", { onClick: () => H({ do: "edit", what: "take" }), children: "Ask for control" })
      ] });
    case "no-lamps":
      return l(ce, { tone: "calm", children: [
        "This scene has no light. Add:",
        l(
          "button",
          {
            onClick: () => {
              dr.value = "disc", mr("add");
            },
            children: "ceiling lamp"
          }
        ),
        l("button", { disabled: !0, title: "Photometric files come with a later version", children: "IES file" })
      ] });
    case "all-off":
      return l(ce, { tone: "warn", children: [
        "All lamps are off.",
        rt.value.undo && l("button", { onClick: () => oe("undo"), children: "Undo" }),
        l("button", { onClick: Ul, children: "Turn on" })
      ] });
    case "slow":
      return l(ce, { tone: "calm", children: [
        "Slow connection.",
        l("button", { "aria-pressed": We.value, onClick: () => We.value = !0, children: "Sharper" }),
        l("button", { "aria-pressed": !We.value, onClick: () => We.value = !1, children: "Faster" })
      ] });
    default:
      return null;
  }
}
function ts() {
  let e = ke.value;
  return l("div", { class: "banners", "data-scroll": !0, children: [
    Wl(),
    Qe.value.length > 0 && l(ce, { tone: "calm", children: [
      l("details", { children: [
        l("summary", { children: [
          Qe.value.length,
          " edits no longer find what they changed"
        ] }),
        l("ul", { children: Qe.value.map((t) => l("li", { children: t }, t)) })
      ] }),
      l("button", { onClick: () => Qe.value = [], children: "Good" })
    ] }),
    e.length > 0 && l("div", { class: "banner badge", role: "status", children: [
      "Solo: ",
      e.length === 1 ? M.get(e[0])?.name ?? "one lamp" : `${e.length} lamps`,
      l("button", { onClick: Cr, children: "End solo" })
    ] }),
    l("div", { class: "notes", role: "status", "aria-live": "polite", children: ct.value.map((t) => l("div", { class: `banner ${t.tone === "warn" ? "warn" : "calm"}`, children: [
      t.text,
      l("button", { class: "icon", "aria-label": "Close", onClick: () => or(t.id), children: l(G, { name: "close" }) })
    ] }, t.id)) })
  ] });
}

// src/view.tsx
var os = g(null);
function Bl(e, t) {
  let n = Qa();
  if (!n) return [];
  let [o, r] = [Math.min(e[0], t[0]), Math.max(e[0], t[0])], [i, a] = [Math.min(e[1], t[1]), Math.max(e[1], t[1])];
  return n.filter(({ at: s }) => s[0] >= o && s[0] <= r && s[1] >= i && s[1] <= a).map(({ id: s }) => s);
}
var zl = {
  click(e, t, n) {
    let o = ns(e, t);
    if (z.peek() === null && o) return ze(o.kind, o.id, n);
    wo(e, t, (r) => {
      if (r && (to.value = { point: r.point, normal: r.normal }), z.peek() !== null) return da(r);
      sa(r, n), P.peek() && (Ie.value = "inspector");
    });
  },
  menu(e, t) {
    wo(e, t, (n) => {
      n && fo(e, t, n);
    });
  },
  double() {
    fr();
  },
  hover(e, t) {
    let n = ns(e, t);
    n?.kind === "lamp" && (me.value = { kind: "lamp", id: n.id }), wo(e, t, (o) => {
      _o.value = o, o && (to.value = { point: o.point, normal: o.normal }), o?.lamp != null && (me.value = { kind: "lamp", id: o.lamp });
    });
  },
  unhover() {
    me.peek() && (me.value = null);
  },
  marquee(e, t, n) {
    if (os.value = n ? null : { from: e, to: t }, !n) return;
    let o = Bl(e, t);
    P.value = o.length ? { kind: "lamp", ids: o } : null, z.value = null;
  }
};
function ns(e, t) {
  let n = document.getElementById("overlay"), o = null, r = 11;
  for (let i of n?.querySelectorAll(".mark:not([display])") ?? []) {
    let a = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(i.getAttribute("transform") ?? "");
    if (!a) continue;
    let s = Math.hypot(Number(a[1]) - e, Number(a[2]) - t);
    s < r && (r = s, o = { kind: i.dataset.kind, id: Number(i.dataset.id) });
  }
  return o;
}
var Gl = {
  aim: "Click what shall be lit. Esc to leave.",
  place: "Click the surface on which the lamp shall be. Esc to leave.",
  meter: "Click where the meter shall lie. Esc to leave.",
  grid: "Click two opposite corners of the area. Esc to leave.",
  add: "Click where the lamp shall hang. Esc to leave.",
  marquee: "Drag around the lamps to select. Esc to leave."
};
function rs() {
  let e = te(null), t = te(null), n = te(null);
  return Ce(() => {
    Xo(t.current);
    let o = Za(n.current), r = Ya(e.current, zl);
    return () => {
      Xo(null), o(), r();
    };
  }, []), Ti(() => {
    let o = W.value;
    t.current?.setAttribute("data-kind", o?.head.kind ?? "none");
  }), l("main", { class: "view", "aria-label": "View", children: [
    l(
      "div",
      {
        class: z.value ? "stage tooled" : "stage",
        id: "view",
        ref: e,
        tabIndex: 0,
        role: "application",
        "aria-label": `View of ${Z.value?.name ?? "the scene"}${Ht.value ? `, ${Ht.value}` : ""}`,
        "aria-describedby": "view-keys",
        "data-tool": z.value ?? "",
        children: [
          l("canvas", { ref: t, width: 640, height: 480, "aria-hidden": "true" }),
          l("svg", { id: "overlay", ref: n, "aria-hidden": "true" }),
          l(ee, { part: "Gizmo" }),
          l(ee, { part: "Compare" }),
          l(Xl, {})
        ]
      }
    ),
    l("p", { id: "view-keys", class: "spoken", children: "Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection, Escape leaves the view." }),
    z.value && l("p", { class: "hint", role: "status", children: Gl[z.value] }),
    l(ts, {}),
    l(ee, { part: "Legend" }),
    l(ee, { part: "CutBar" }),
    l(ee, { part: "ViewStrip" }),
    l(ee, { part: "WalkPad" }),
    l(ee, { part: "What" })
  ] });
}
function Xl() {
  let e = os.value;
  if (!e) return null;
  let { from: t, to: n } = e;
  return l("svg", { class: "rubber", "aria-hidden": "true", children: l(
    "rect",
    {
      x: Math.min(t[0], n[0]),
      y: Math.min(t[1], n[1]),
      width: Math.abs(n[0] - t[0]),
      height: Math.abs(n[1] - t[1])
    }
  ) });
}

// src/main.tsx
function Yl() {
  return l(X, { children: [
    l(xa, {}),
    l(Ua, {}),
    l(rs, {}),
    l("section", { class: "panel inspector", "aria-label": "Inspector", children: l(ee, { part: "Inspector" }) }),
    l("section", { class: "strip", "aria-label": "Looks and meters", children: l(ee, { part: "Strip" }) }),
    l(Ga, {}),
    l(ee, { part: "Sheets" })
  ] });
}
var ht = document.getElementById("desk");
ht.replaceChildren();
li(l(Yl, {}), ht);
T(() => {
  ht.dataset.state = Wt.value, ht.dataset.line = U.value, ht.dataset.pen = pe.value === "edit" && F.value.you && !ye.value ? "yes" : "no";
});
T(() => {
  ht.dataset.panels = Zo.value ? "yes" : "no", ht.dataset.drawer = Ie.value ?? "none";
});
T(() => {
  document.documentElement.dataset.theme = Yo.value, document.documentElement.style.setProperty("--house", String(Qo.value));
});
T(() => {
  Z.value && (document.title = `${Z.value.name} – Lampyris`);
});
var zr = 0;
T(() => {
  let [e, t] = _e.value, n = We.value ? Math.min(devicePixelRatio, 2) : 1;
  U.value !== "open" || pe.value === "watch" || !F.value.you || (clearTimeout(zr), zr = window.setTimeout(() => H({ do: "size", width: Math.round(e * n), height: Math.round(t * n) }), zr && 60));
});
ba();
Aa();
Xi();
export {
  _n as Fade,
  gn as Field,
  X as Fragment,
  Be as Gesture,
  G as Icon,
  Sr as Item,
  Vs as PRESETS,
  Kr as Range,
  Nr as Virtual,
  ot as across,
  oe as act,
  I as add,
  dr as adding,
  ml as allActions,
  Se as ask,
  ma as asked,
  Zs as back,
  pn as before,
  he as camera,
  Vt as candles,
  le as chosenLamps,
  Cr as clearSolo,
  po as closeWhat,
  Ka as colorText,
  ao as command,
  dn as compareHeld,
  de as comparing,
  Ri as compass,
  N as computed,
  yr as copyText,
  Dr as cost,
  ge as cross,
  Hr as css,
  il as cut,
  Zn as deselect,
  B as digits,
  at as display,
  He as distance,
  q as dot,
  ll as each,
  Le as edit,
  F as editor,
  T as effect,
  so as exposeBy,
  nr as fade,
  cl as falseColor,
  Is as filterOf,
  We as fine,
  hn as fitted,
  vn as format,
  el as forth,
  fr as frameSelection,
  ro as free,
  Vl as fromHex,
  Q as go,
  pr as goHome,
  rl as goInside,
  ol as goPreset,
  qn as grids,
  D as groups,
  Ys as handles,
  Xn as hands,
  xe as hear,
  ne as here,
  Oa as hex,
  co as highlight,
  rt as history,
  Qo as houseLights,
  me as hovered,
  l as jsx,
  l as jsxs,
  tr as lampMarks,
  M as lamps,
  sn as layers,
  Oe as length,
  Lt as listing,
  ye as lookOnly,
  Mt as looks,
  Uo as lumensOf,
  dt as luxText,
  js as maintenance,
  xt as materials,
  Ct as meters,
  qe as middle,
  Il as mired,
  aa as nameOf,
  J as normal,
  sl as onTool,
  st as output,
  El as padWalk,
  Zo as panels,
  Qn as penless,
  Ae as percent,
  Fr as pickRow,
  wt as pinhole,
  hr as positionOf,
  tn as project,
  Ls as ray,
  dl as register,
  pe as role,
  se as say,
  S as scale,
  Z as scene,
  ze as select,
  P as selection,
  H as send,
  al as setCut,
  pt as sheet,
  At as show,
  W as shown,
  g as signal,
  er as singleKeys,
  bl as soloSelection,
  to as spot,
  mr as startTool,
  Te as status,
  Bs as step,
  Qs as stepSelection,
  pl as storeLook,
  fl as storeView,
  rr as stroke,
  go as strokeLevel,
  K as sub,
  Or as switchOn,
  Yo as theme,
  be as things,
  Xe as three,
  eo as titleOf,
  Vr as toLevel,
  Lr as toTravel,
  br as toggleFalse,
  Xs as toggleWipe,
  z as tool,
  Yn as travel,
  en as turn,
  Rr as typeGroupLevel,
  Ar as typeLevel,
  Ve as up,
  Ce as useEffect,
  gs as useLayoutEffect,
  te as useRef,
  Ht as viewName,
  _e as viewSize,
  St as views,
  Va as walkNames,
  Jo as walking,
  gr as wantLevel,
  Ye as what,
  Jn as whyNot,
  _r as whyNotTo,
  zs as wipeAt
};
