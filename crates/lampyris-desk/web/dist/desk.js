// node_modules/preact/dist/preact.mjs
var C, ii, To, Ne, Co, Rn, ai, Vn, si, Po, Eo, hs, Bt = /* @__PURE__ */ Symbol.for("pv"), An = {}, Hn = [], vs = /^m(i|n|o|s|text|space)$/, $o = Array.isArray, Lo = Hn.slice, et = Object.assign;
function Ze(e) {
  e && e.parentNode && e.remove();
}
function li(e, t, n) {
  var o, r, i, a = {}, s = arguments.length;
  for (i in t) i == "key" ? o = t[i] : i == "ref" && typeof e != "function" ? r = t[i] : a[i] = t[i];
  return s > 2 && (a.children = s > 3 ? Lo.call(arguments, 2) : n), Wt(e, a, o, r, null);
}
function Wt(e, t, n, o, r) {
  var i = { type: e, props: t, key: n, ref: o, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: Bt, __v: r || ++ii, __i: -1, __u: 0 };
  return !r && C.vnode && C.vnode(i), i;
}
function Y(e) {
  return e.children;
}
function vt(e, t) {
  this.props = e, this.context = t, this.__g = 0;
}
function qe(e, t) {
  if (t == null) return e.__ && qe(e.__, e.__i + 1);
  for (var n; t < e.__k.length; t++) if ((n = e.__k[t]) && n.__e) return n.__e;
  return typeof e.type != "function" || e.props.__P ? null : qe(e);
}
function gs(e) {
  var t, n = e.__v, o = n.__e, r = [], i = [], a = e.__P;
  a && ((t = et({ constructor: Bt }, n)).__v = n.__v + 1, C.vnode && C.vnode(t), Vo(a, t, n, e.__n, a.namespaceURI, 32 & n.__u ? [o] : null, r, o || qe(n), 32 & n.__u, i), t.__v = n.__v, t.__.__k[t.__i] = t, mi(r, t, i), n.__ = n.__e = null, t.__e != o && ui(t));
}
function ui(e) {
  if ((e = e.__) && e.__c && !e.props.__P) return e.__e = null, e.__k.some(function(t) {
    return t && (e.__e = t.__e);
  }), ui(e);
}
function oi(e) {
  (8 & e.__g || (e.__g |= 8, Ne.push(e), Rn++)) && Co == C.debounceRendering || ((Co = C.debounceRendering) || queueMicrotask)(ci);
}
function ci() {
  try {
    for (var e, t = 1; Ne.length; ) Ne.length > t && Ne.sort(ai), e = Ne.shift(), t = Ne.length, 8 & e.__g && gs(e);
  } finally {
    (Rn = Ne.length) && (Co || queueMicrotask)(ci);
  }
}
function fi(e, t, n, o, r, i, a, s, p, u, c) {
  var d, m, f, b, y, x, S = o.__k || Hn, w = t.length;
  for (p = bs(n, t, S, p, w), d = 0; d < w; d++) (f = n.__k[d]) != null && (m = ~f.__i && S[f.__i] || An, f.__i = d, x = Vo(e, f, m, r, i, a, s, p, u, c), b = f.__e, (m.ref != f.ref || 8 & m.__u) && (m.ref && Io(m.ref, null, f, m), f.ref && c.push(f.ref, f.__c || b, f)), y = y || b, 4 & f.__u ? (p = pi(f, p, e, !m.__v), m.__e && (m.__e = null)) : typeof f.type == "function" && x !== void 0 ? p = x : b && (p = b.nextSibling), f.__u &= -21);
  return n.__e = y, p;
}
function bs(e, t, n, o, r) {
  var i, a, s, p, u, c, d, m, f, b = n.length, y = b, x = 0, S = 0, w = e.__k = Array(r);
  for (i = 0; i < r; i++) (a = t[i]) != null && typeof a != "boolean" && typeof a != "function" ? (typeof a != "object" || a.constructor === String ? a = w[i] = Wt(null, a) : $o(a) ? a = w[i] = Wt(Y, { children: a }) : a.constructor === Bt && a.__b ? a = w[i] = Wt(a.type, a.props, a.key, a.ref, a.__v) : w[i] = a, p = i + x, a.__ = e, a.__b = e.__b + 1, s = null, ~(u = a.__i = ys(a, n, p, y)) && (y--, (s = n[u]) && (s.__u |= 2)), s && s.__v ? (a.__u |= 16, u == p - 1 ? x-- : u == p + 1 ? x++ : u != p && (u > p ? x-- : x++, S = 1)) : (~u || (r > b ? x-- : r < b && x++), typeof a.type != "function" && (a.__u |= 4))) : w[i] = null;
  if (S) {
    for (c = [], d = [], i = 0; i < r; i++) if ((a = w[i]) && 16 & a.__u) {
      for (x = 0, m = c.length; x < m; ) c[f = x + m >> 1] < a.__i ? x = f + 1 : m = f;
      c[x] = a.__i, d[i] = x + 1;
    }
    for (x = c.length; i--; ) d[i] && (d[i] == x ? x-- : w[i].__u |= 4);
  }
  if (y) for (i = 0; i < b; i++) !(s = n[i]) || 2 & s.__u || (s.__e == o && (o = qe(s)), Ro(s, s));
  return o;
}
function pi(e, t, n, o) {
  var r, i, a, s;
  if (typeof e.type == "function") {
    if (e.props.__P) return t;
    if (r = e.__k) for (i = 0; i < r.length; i++) r[i] && (r[i].__ = e, t = pi(r[i], t, n, !1));
    return t;
  }
  for (t && !t.parentNode && (t = qe(e)) && !t.parentNode && (t = null), a = e.__e, s = t; s && s.nodeType == 8; ) s = s.nextSibling;
  for (a != s && (!o && n.moveBefore && a.parentNode ? n.moveBefore(a, t) : n.insertBefore(a, t || null)), t = a; (t = t && t.nextSibling) && t.nodeType == 8 && !t.data.startsWith("$s"); ) ;
  return t;
}
function ys(e, t, n, o) {
  var r, i = e.key, a = e.type, s = t[n], p = s && !(2 & s.__u);
  if (s === null && i == null || p && i == s.key && a == s.type) return n;
  if (o > (p ? 1 : 0)) {
    for (r = n - 1; r >= 0; r--) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
    for (r = n + 1; r < t.length; r++) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
  }
  return -1;
}
function ri(e, t, n) {
  n == null && (n = ""), t[0] == "-" ? e.setProperty(t, n) : e[t] = n;
}
function Ln(e, t, n, o, r) {
  var i, a;
  if (t == "style") if (typeof n == "string") e.style.cssText = n;
  else {
    if (typeof o == "string" && (e.style.cssText = o = ""), o) for (t in o) n && t in n || ri(e.style, t);
    if (n) for (t in n) o && n[t] == o[t] || ri(e.style, t, n[t]);
  }
  else if (t[0] == "o" && t[1] == "n") typeof n != "function" && (n = null), typeof o != "function" && (o = null), (e.__e || (e.__e = {}))[t] = n, n && o || (a = Eo[t] || (Eo[t] = _s(t)), (e.__a || (e.__a = {}))[t] = Po, i = t != (t = t.replace(si, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), n ? e.addEventListener(t, a, i) : e.removeEventListener(t, a, i));
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
function _s(e) {
  return function(t) {
    var n = this.__e;
    if (n) {
      if (n = n[e], t[Vn] == null) t[Vn] = Po++;
      else if (t[Vn] < this.__a[e]) return;
      return n(C.event ? C.event(t) : t);
    }
  };
}
function Vo(e, t, n, o, r, i, a, s, p, u) {
  var c, d, m, f, b, y, x, S, w, M, I, Me, Je, fe, ve, h, v, T, P = t.type;
  if (t.constructor !== Bt) return null;
  128 & n.__u && (p = 32 & n.__u, c = n.__c.__z) && (t.__u |= p, d = i = [], c.nodeType == 8 ? s = In(c, i) : i.push(c), s = i[0] || s), (c = C.__b) && c(t);
  e: if (typeof P == "function") {
    m = a.length;
    try {
      if (S = t.props, w = (c = P.prototype) && c.render, M = (c = P.contextType) && o[c.__c], I = c ? M ? M.props.value : c.__ : o, (f = n.__c) ? (t.__c = f, 2 & f.__g && (f.__g |= 1)) : (w ? t.__c = f = new P(S, I) : (t.__c = f = new vt(S, I), f.constructor = P, f.render = ks), M && M.sub(f), f.state || (f.state = {}), f.__n = o, f.__g |= 8, f.__h = [], f.__k = []), w && (f.__s || (f.__s = f.state), P.getDerivedStateFromProps && (f.__s == f.state && (f.__s = et({}, f.__s)), et(f.__s, P.getDerivedStateFromProps(S, f.__s)))), b = f.props, y = f.state, f.__v = t, n.__c) {
        if (S !== b && w && !P.getDerivedStateFromProps && f.componentWillReceiveProps && f.componentWillReceiveProps(S, I), t.__v == n.__v && !(8 & f.__g) || !(4 & f.__g) && f.shouldComponentUpdate && f.shouldComponentUpdate(S, f.__s, I) === !1) {
          t.__v != n.__v && (f.props = S, f.state = f.__s, f.__g &= -9), t.__e = n.__e, t.__k = n.__k, t.__k.some(function($) {
            $ && ($.__ = t);
          }), Hn.push.apply(f.__h, f.__k), f.__k = [], f.__h.length && a.push(f), s = qe(n);
          break e;
        }
        f.componentWillUpdate && f.componentWillUpdate(S, f.__s, I), w && f.componentDidUpdate && f.__h.push(function() {
          f.componentDidUpdate(b, y, x);
        });
      } else w && !P.getDerivedStateFromProps && f.componentWillMount && f.componentWillMount(), w && f.componentDidMount && f.__h.push(f.componentDidMount);
      f.context = I, f.props = S, f.__P = e, f.__g &= -5, Me = C.__r, Je = w ? 25 : 0;
      do
        f.__g &= -9, Me && Me(t), c = f.render(f.props, f.state = f.__s, f.context);
      while (8 & f.__g && ++Je < 25);
      w && (Hn.push.apply(f.__h, f.__k), f.__k = []), f.state = f.__s, f.getChildContext && (o = et({}, o, f.getChildContext())), w && n.__c && f.getSnapshotBeforeUpdate && (x = f.getSnapshotBeforeUpdate(b, y)), fe = c && c.type === Y && c.key == null ? c.props.children : c, S.__P && (c = s, r = (e = S.__P).namespaceURI, p = i = null, n.props && n.props.__P != e && (n.__k.some(function($) {
        $ && Ro($, $);
      }), n.__k = null), s = n.__k ? qe(n, 0) : null), s = fi(e, $o(fe) ? fe : [fe], t, n, o, r, i, a, s, p, u), S.__P && (t.__e = null, s = c), t.__u &= -161, d && d.some(Ze), f.__h.length && a.push(f), 1 & f.__g && (f.__g &= -4);
    } catch ($) {
      if (a.length = m, t.__v = null, p || i) if ($ && $.then) {
        if (t.__u |= 128 | p, i) {
          for (~(v = i.indexOf(s || void 0)) || (v = i.length); (T = i[v - 1]) && T.nodeType == 8; ) v--;
          for (; v < i.length; v++) if (T = i[v]) if (i[v] = null, ve) {
            if (T == h) break;
          } else {
            if (T.nodeType != 8) break;
            T.data.startsWith("$s") && (h = In(ve = T));
          }
        }
        if (!ve) {
          for (; s && s.nodeType == 8 && s.nextSibling; ) s = s.nextSibling;
          ve = s;
        }
        (c = In(ve = t.__c.__z || (t.__c.__z = ve))) ? (t.__e = ve, s = c) : t.__e = s, s = s && s.nextSibling;
      } else i && i.some(Ze);
      else t.__e = n.__e;
      t.__k || (t.__k = n.__k || []), $ && $.then || di(t), C.__e($, t, n);
    }
  } else s = t.__e = ws(n.__e, t, n, o, r, i, a, p, u, e);
  return (c = C.diffed) && c(t), s;
}
function In(e, t) {
  if (e && e.nodeType == 8 && e.data.startsWith("$s")) for (var n = 1; e = e.nextSibling; ) {
    if (e.nodeType == 8) {
      if (e.data.startsWith("$s")) n++;
      else if (e.data.startsWith("/$s") && !--n) return e;
    }
    t && t.push(e);
  }
}
function di(e) {
  e && (e.__c && (e.__c.__g |= 4), e.__k && e.__k.some(di));
}
function mi(e, t, n) {
  for (var o = 0; o < n.length; ) Io(n[o++], n[o++], n[o++]);
  C.__c && C.__c(t, e), e.some(function(r) {
    try {
      e = r.__h, r.__h = [], e.some(function(i) {
        i.call(r);
      });
    } catch (i) {
      C.__e(i, r.__v);
    }
  });
}
function ws(e, t, n, o, r, i, a, s, p, u) {
  var c, d, m, f, b, y, x, S, w = n.props || An, M = t.props, I = t.type;
  if (I == "svg" ? r = "http://www.w3.org/2000/svg" : I == "math" ? r = "http://www.w3.org/1998/Math/MathML" : r || (r = "http://www.w3.org/1999/xhtml"), i) {
    for (c = 0; c < i.length; c++) if ((b = i[c]) && (I ? b.localName == I : b.nodeType == 3)) {
      e = b, i[c] = null;
      break;
    }
  }
  if (!e) {
    if (S = u.ownerDocument || document, !I) return S.createTextNode(M);
    e = S.createElementNS(r, I, M.is ? M : u), s && (C.__m && C.__m(t, i), s = !1), i = null;
  }
  if (I) {
    if (u = I == "template" && e.content || e, i = I == "textarea" && M.defaultValue != null ? null : i && Lo.call(u.childNodes), !s && i) for (w = {}, c = 0; c < e.attributes.length; c++) w[(b = e.attributes[c]).name] = b.value;
    for (c in w) b = w[c], c == "dangerouslySetInnerHTML" ? m = b : c == "children" || c in M || c == "value" && "defaultValue" in M || c == "checked" && "defaultChecked" in M || Ln(e, c, null, b, r);
    for (c in M) b = M[c], c == "children" ? f = b : c == "dangerouslySetInnerHTML" ? d = b : c == "value" ? y = b : c == "checked" ? x = b : s && typeof b != "function" || w[c] === b || Ln(e, c, b, w[c], r);
    d ? (s || m && (d.__html == m.__html || d.__html == e.innerHTML) || (e.innerHTML = d.__html), t.__k = []) : (m && (e.textContent = ""), (I == "foreignObject" || r == "http://www.w3.org/1998/Math/MathML" && vs.test(I)) && (r = "http://www.w3.org/1999/xhtml"), fi(u, $o(f) ? f : [f], t, n, o, r, i, a, i ? i[0] : n.__k && qe(n, 0), s, p), i && i.some(Ze)), s && I != "textarea" || (c = "value", I == "progress" && y == null ? e.removeAttribute(c) : y == null || y === e[c] && (I != "progress" || y) || Ln(e, c, y, w[c], r), c = "checked", x != null && x != e[c] && Ln(e, c, x, w[c], r));
  } else w === M || s && e.data == M || (e.data = M);
  return e;
}
function Io(e, t, n, o) {
  try {
    typeof e == "function" ? t ? t.__x = e(t) || 1 : o && (o = o.__c || o.__e) && (t = o.__x) && (o.__x = null, typeof t == "function" ? t() : e(null)) : e.current = t;
  } catch (r) {
    C.__e(r, n);
  }
}
function Ro(e, t, n) {
  var o, r, i, a;
  if (C.unmount && C.unmount(e), !(o = e.ref) || o.current && o.current != e.__e || Io(o, null, t, e), o = e.__c) {
    if (o.componentWillUnmount) try {
      o.componentWillUnmount();
    } catch (s) {
      C.__e(s, t);
    }
    o.__P = o.__n = null;
  }
  if (o = e.__k) for (a = 0; a < o.length; a++) o[a] && Ro(o[a], t, typeof e.type != "function" || n && !e.props.__P);
  !n && (o = e.__c) && (o = o.__z) && (r = In(o, i = [])) && (o == e.__e && i.some(Ze), Ze(r), Ze(o)), n || Ze(e.__e), e.__e = e.__c = e.__ = null;
}
function ks(e, t, n) {
  return this.constructor(e, n);
}
function hi(e, t) {
  var n, o, r, i;
  C.__ && C.__(e, t), t.nodeType == 9 && (t = t.documentElement), o = (n = e && 32 & e.__u) ? null : t.__k, t.__k = Wt(Y, { children: [e] }), r = [], i = [], Vo(t, t.__k, o || An, An, t.namespaceURI, o ? null : t.firstChild ? Lo.call(t.childNodes) : null, r, o ? o.__e : t.firstChild, n, i), mi(r, t.__k, i), t.__k.props.children = null;
}
C = { __e: function(e, t, n, o) {
  for (var r, i, a; t = t.__; ) if ((r = t.__c) && !(1 & r.__g)) {
    r.__g |= 4;
    try {
      if ((a = (i = r.constructor) && i.getDerivedStateFromError) && r.setState(i.getDerivedStateFromError(e)), r.componentDidCatch && (r.componentDidCatch(e, o || {}), a = 1), a && 8 & r.__g) return void (r.__g |= 2);
    } catch (s) {
      e = s;
    }
  }
  throw Rn = 0, e;
} }, ii = 0, To = function(e) {
  return e != null && e.constructor === Bt;
}, vt.prototype.setState = function(e, t) {
  var n = this.__s;
  n && n != this.state || (n = this.__s = et({}, this.state)), typeof e == "function" && (e = e(et({}, n), this.props)), e && (et(n, e), this.__v && (t && this.__k.push(t), oi(this)));
}, vt.prototype.forceUpdate = function(e) {
  this.__v && (this.__g |= 4, e && this.__h.push(e), oi(this));
}, vt.prototype.render = Y, Ne = [], Rn = 0, ai = function(e, t) {
  return e.__v.__b - t.__v.__b;
}, Vn = /* @__PURE__ */ Symbol(), si = /(PointerCapture)$|Capture$/i, Po = 0, Eo = {}, hs = 0;

// node_modules/preact/hooks/dist/hooks.mjs
var zt, re, Ao, vi, xs = Object.is, Ho = 0, Mi = [], Ko = [], U = C, gi = U.__b, bi = U.__r, yi = U.diffed, _i = U.__c, wi = U.unmount, ki = U.__;
function Do(e, t) {
  U.__h && U.__h(re, e, Ho || t), Ho = 0;
  var n = re.__H || (re.__H = { __: [], __h: [] });
  return e >= n.__.length && n.__.push({}), n.__[e];
}
function Ce(e, t) {
  var n = Do(zt++, 3);
  !U.__s && Fo(n.__H, t) && (n.__P = !0, n.__ = e, n.u = t, re.__H.__h.push(n));
}
function Ss(e, t) {
  var n = Do(zt++, 4);
  !U.__s && Fo(n.__H, t) && (n.__P = !1, n.__ = e, n.u = t, re.__h.push(n));
}
function ne(e) {
  return Ho = 5, Kn(function() {
    return { current: e };
  }, []);
}
function Kn(e, t) {
  var n = Do(zt++, 7);
  return Fo(n.__H, t) && (n.__ = e(), n.__H = t), n.__;
}
function Ms() {
  var e;
  do {
    for (; e = Ko.shift(); ) try {
      Gt(e);
    } catch (n) {
      U.__e(n, { __: (e = e.__P) && e.__v });
    }
    for (; e = Mi.shift(); ) {
      var t = e.__H;
      if (e.__P && t) try {
        t.__h.some(Gt), t.__h.some(Oo), t.__h = [];
      } catch (n) {
        t.__h = [], U.__e(n, e.__v);
      }
    }
  } while (Ko.length);
}
U.__b = function(e) {
  re = null, gi && gi(e);
}, U.__ = function(e, t) {
  e && t.__k && t.__k.__m && (e.__m = t.__k.__m), ki && ki(e, t);
}, U.__r = function(e) {
  bi && bi(e), zt = 0;
  var t = (re = e.__c).__H;
  t && (Ao == re ? re.__h = [] : (t.__h.some(Gt), t.__h.some(Oo), zt = 0), t.__h = [], t.__.some(function(n) {
    n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
  })), Ao = re;
}, U.diffed = function(e) {
  yi && yi(e);
  var t = e.__c;
  t && t.__H && (t.__H.__h.length && Si(Mi.push(t)), t.__H.__.some(function(n) {
    n.u && (n.__H = n.u);
  })), Ao = re = null;
}, U.__c = function(e, t) {
  t.some(function(n) {
    try {
      n.__h.some(Gt), n.__h = n.__h.filter(function(o) {
        return !o.__ || Oo(o);
      });
    } catch (o) {
      n.__h = [function() {
        throw o;
      }];
    }
  }), _i && _i(e, t);
}, U.unmount = function(e) {
  wi && wi(e);
  var t, n, o = e.__c;
  o && o.__H && (o.__H.__.some(function(r) {
    try {
      if (r.__P && r.__c) {
        if (n === void 0) {
          for (n = e.__; n && (!n.__c || !n.__c.__P); ) n = n.__;
          n = n && n.__c;
        }
        r.__P = n, Si(Ko.push(r));
      } else Gt(r);
    } catch (i) {
      t = i;
    }
  }), o.__H = void 0, t && U.__e(t, o.__v));
};
var xi = typeof requestAnimationFrame == "function";
function Cs(e) {
  var t, n = function() {
    clearTimeout(o), xi && cancelAnimationFrame(t), setTimeout(e);
  }, o = setTimeout(n, 35);
  xi && (t = requestAnimationFrame(n));
}
function Si(e) {
  e != 1 && vi == U.requestAnimationFrame || ((vi = U.requestAnimationFrame) || Cs)(Ms);
}
function Gt(e) {
  var t = re, n = e.__c;
  typeof n == "function" && (e.__c = void 0, n()), re = t;
}
function Oo(e) {
  var t = re;
  e.__c = e.__(), re = t;
}
function Fo(e, t) {
  return !e || e.length != t.length || t.some(function(n, o) {
    return !xs(n, e[o]);
  });
}

// node_modules/@preact/signals-core/dist/signals-core.module.js
var Es = /* @__PURE__ */ Symbol.for("preact-signals");
function Nn() {
  if (Ae > 1)
    Ae--;
  else {
    var e, t = !1;
    for ((function() {
      var r = Dn;
      for (Dn = void 0; r !== void 0; ) {
        var i = r.S;
        if (i.v === r.v) for (var a = i.t; a !== void 0; a = a.x) a.i === r.i && (a.i = i.i);
        r = r.o;
      }
    })(); Yt !== void 0; ) {
      var n = Yt;
      for (Yt = void 0, On++; n !== void 0; ) {
        var o = n.u;
        if (n.u = void 0, n.f &= -3, !(8 & n.f) && Ei(n)) try {
          n.c();
        } catch (r) {
          t || (e = r, t = !0);
        }
        n = o;
      }
    }
    if (On = 0, Ae--, t) throw e;
  }
}
function qn(e) {
  if (Ae > 0) return e();
  No = ++Ts, Ae++;
  try {
    return e();
  } finally {
    Nn();
  }
}
var Xt, H = void 0;
function ue(e) {
  var t = H, n = Xt;
  H = void 0, Xt = void 0;
  try {
    return e();
  } finally {
    H = t, Xt = n;
  }
}
var Yt = void 0, Ae = 0, On = 0, Ts = 0, No = 0, Dn = void 0, Fn = 0;
function Ci(e) {
  if (H !== void 0) {
    var t = e.n;
    if (t === void 0 || t.t !== H)
      return t = { i: 0, S: e, p: H.s, n: void 0, t: H, e: void 0, x: void 0, r: t }, H.s !== void 0 && (H.s.n = t), H.s = t, e.n = t, 32 & H.f && e.S(t), t;
    if (t.i === -1)
      return t.i = 0, t.n !== void 0 && (t.n.p = t.p, t.p !== void 0 && (t.p.n = t.n), t.p = H.s, t.n = void 0, H.s.n = t, H.s = t), t;
  }
}
function Q(e, t) {
  this.v = e, this.i = 0, this.n = void 0, this.t = void 0, this.l = 0, this.W = t?.watched, this.Z = t?.unwatched, this.name = t?.name;
}
Q.prototype.brand = Es;
Q.prototype.h = function() {
  return !0;
};
Q.prototype.S = function(e) {
  var t = this, n = this.t;
  n !== e && e.e === void 0 && (e.x = n, this.t = e, n !== void 0 ? n.e = e : ue(function() {
    var o;
    (o = t.W) == null || o.call(t);
  }));
};
Q.prototype.U = function(e) {
  var t = this;
  if (this.t !== void 0) {
    var n = e.e, o = e.x;
    n !== void 0 && (n.x = o, e.e = void 0), o !== void 0 && (o.e = n, e.x = void 0), e === this.t && (this.t = o, o === void 0 && ue(function() {
      var r;
      (r = t.Z) == null || r.call(t);
    }));
  }
};
Q.prototype.subscribe = function(e) {
  var t = this;
  return L(function() {
    var n = t.value;
    ue(function() {
      return e(n);
    });
  }, { name: "sub" });
};
Q.prototype.valueOf = function() {
  return this.value;
};
Q.prototype.toString = function() {
  return this.value + "";
};
Q.prototype.toJSON = function() {
  return this.value;
};
Q.prototype.peek = function() {
  var e = this;
  return ue(function() {
    return e.value;
  });
};
Object.defineProperty(Q.prototype, "value", { get: function() {
  var e = Ci(this);
  return e !== void 0 && (e.i = this.i), this.v;
}, set: function(e) {
  if (e !== this.v) {
    if (On > 100) throw new Error("Cycle detected");
    (function(n) {
      Ae !== 0 && On === 0 && n.l !== No && (n.l = No, Dn = { S: n, v: n.v, i: n.i, o: Dn });
    })(this), this.v = e, this.i++, Fn++, Ae++;
    try {
      for (var t = this.t; t !== void 0; t = t.x) t.t.N();
    } finally {
      Nn();
    }
  }
} });
function g(e, t) {
  return new Q(e, t);
}
function Ei(e) {
  for (var t = e.s; t !== void 0; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return !0;
  return !1;
}
function Ti(e) {
  for (var t = e.s; t !== void 0; t = t.n) {
    var n = t.S.n;
    if (n !== void 0 && (t.r = n), t.S.n = t, t.i = -1, t.n === void 0) {
      e.s = t;
      break;
    }
  }
}
function Pi(e) {
  for (var t = e.s, n = void 0; t !== void 0; ) {
    var o = t.p;
    t.i === -1 ? (t.S.U(t), o !== void 0 && (o.n = t.n), t.n !== void 0 && (t.n.p = o)) : n = t, t.S.n = t.r, t.r !== void 0 && (t.r = void 0), t = o;
  }
  e.s = n;
}
function tt(e, t) {
  Q.call(this, void 0, t), this.x = e, this.s = void 0, this.g = Fn - 1, this.f = 4;
}
tt.prototype = new Q();
tt.prototype.h = function() {
  if (this.f &= -3, 1 & this.f) return !1;
  if ((36 & this.f) == 32 || (this.f &= -5, this.g === Fn)) return !0;
  if (this.g = Fn, this.f |= 1, this.i > 0 && !Ei(this))
    return this.f &= -2, !0;
  var e = H;
  try {
    Ti(this), H = this;
    var t = this.x();
    (16 & this.f || this.v !== t || this.i === 0) && (this.v = t, this.f &= -17, this.i++);
  } catch (n) {
    this.v = n, this.f |= 16, this.i++;
  }
  return H = e, Pi(this), this.f &= -2, !0;
};
tt.prototype.S = function(e) {
  if (this.t === void 0) {
    this.f |= 36;
    for (var t = this.s; t !== void 0; t = t.n) t.S.S(t);
  }
  Q.prototype.S.call(this, e);
};
tt.prototype.U = function(e) {
  if (this.t !== void 0 && (Q.prototype.U.call(this, e), this.t === void 0)) {
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
  var e = Ci(this);
  if (this.h(), e !== void 0 && (e.i = this.i), 16 & this.f) throw this.v;
  return this.v;
} });
function N(e, t) {
  return new tt(e, t);
}
function $i(e) {
  var t = e.j;
  if (e.j = void 0, typeof t == "function") {
    Ae++;
    var n = H;
    H = void 0;
    try {
      t();
    } catch (o) {
      throw e.f &= -2, e.f |= 8, qo(e), o;
    } finally {
      H = n, Nn();
    }
  }
}
function qo(e) {
  for (var t = e.s; t !== void 0; t = t.n) t.S.U(t);
  e.x = void 0, e.s = void 0, $i(e);
}
function Ps(e) {
  if (H !== this) throw new Error("Out-of-order effect");
  Pi(this), H = e, this.f &= -2;
  try {
    8 & this.f && qo(this);
  } finally {
    Nn();
  }
}
function gt(e, t) {
  this.x = e, this.j = void 0, this.s = void 0, this.u = void 0, this.f = 32, this.name = t?.name, Xt && Xt.push(this);
}
gt.prototype.c = function() {
  var e = this.S();
  try {
    if (8 & this.f || this.x === void 0) return;
    var t = this.x();
    typeof t == "function" && (this.j = t);
  } finally {
    e();
  }
};
gt.prototype.S = function() {
  if (1 & this.f) throw new Error("Cycle detected");
  this.f |= 1, this.f &= -9, $i(this), Ti(this), Ae++;
  var e = H;
  return H = this, Ps.bind(this, e);
};
gt.prototype.N = function() {
  2 & this.f || (this.f |= 2, this.u = Yt, Yt = this);
};
gt.prototype.d = function() {
  this.f |= 8, 1 & this.f || qo(this);
};
gt.prototype.dispose = function() {
  this.d();
};
function L(e, t) {
  var n = new gt(e, t);
  try {
    n.c();
  } catch (r) {
    throw n.d(), r;
  }
  var o = n.d.bind(n);
  return o[Symbol.dispose] = o, o;
}

// node_modules/@preact/signals/dist/signals.module.js
var Uo, Jt, Un, $s = typeof window < "u" && !!window.__PREACT_SIGNALS_DEVTOOLS__, Li = [], Vi = [];
L(function() {
  Uo = this.N;
})();
function bt(e, t) {
  C[e] = t.bind(null, C[e] || function() {
  });
}
function Qt(e) {
  if (Un) {
    var t = Un;
    Un = void 0, t();
  }
  Un = e && e.S();
}
function Ii(e) {
  var t = this, n = e.data, o = nt(n);
  o.name = "ReactiveDom", o.value = n;
  var r = Kn(function() {
    for (var s = t, p = t.__v; p = p.__; ) if (p.__c) {
      p.__c.__$f |= 4;
      break;
    }
    var u = N(function() {
      var f = o.value.value;
      return f === 0 ? 0 : f === !0 ? "" : f || "";
    }), c = N(function() {
      return !Array.isArray(u.value) && !To(u.value);
    }), d = L(function() {
      if (this.N = Ri, c.value) {
        var f = u.value;
        s.__v && s.__v.__e && s.__v.__e.nodeType === 3 && (s.__v.__e.data = f);
      }
    }), m = t.__$u.d;
    return t.__$u.d = function() {
      d(), m.call(this);
    }, [c, u];
  }, []), i = r[0], a = r[1];
  return i.value ? a.peek() : a.value;
}
Ii.displayName = "ReactiveTextNode";
Object.defineProperties(Q.prototype, { constructor: { configurable: !0, value: li(Y, null).constructor }, type: { configurable: !0, value: Ii }, props: { configurable: !0, get: function() {
  var e = this;
  return { data: { get value() {
    return e.value;
  } } };
} }, __b: { configurable: !0, value: 1 } });
bt("__b", function(e, t) {
  if (Qt(), Jt = void 0, typeof t.type == "string") {
    var n, o = t.props;
    for (var r in o) if (r !== "children") {
      var i = o[r];
      i instanceof Q && (n || (t.__np = n = {}), n[r] = i, o[r] = i.peek());
    }
  }
  e(t);
});
bt("__r", function(e, t) {
  if (e(t), t.type !== Y) {
    Qt();
    var n, o = t.__c;
    o && (o.__$f &= -2, (n = o.__$u) === void 0 && (o.__$u = n = (function(r, i) {
      var a;
      return L(function() {
        a = this;
      }, { name: i }), a.c = r, a;
    })(/* @__PURE__ */ (function(r) {
      return function() {
        var i;
        $s && ((i = this.y) == null || i.call(this)), r.__$f |= 1, r.setState({});
      };
    })(o), typeof t.type == "function" ? t.type.displayName || t.type.name : ""))), Jt = o, Qt(n);
  }
});
bt("__e", function(e, t, n, o) {
  Qt(), Jt = void 0, e(t, n, o);
});
bt("diffed", function(e, t) {
  Qt(), Jt = void 0;
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
        var u = i[p], c = o[p];
        u === void 0 ? (u = Ls(n, p, c, r), i[p] = u) : u.o(c, r);
      }
    }
  }
  e(t);
});
function Ls(e, t, n, o) {
  var r = t in e && e.ownerSVGElement === void 0, i = g(n);
  return { o: function(a, s) {
    i.value = a, o = s;
  }, d: L(function() {
    this.N = Ri;
    var a = i.value.value;
    o[t] !== a && (o[t] = a, r ? e[t] = a : a != null && (a !== !1 || t[4] === "-") ? e.setAttribute(t, a) : e.removeAttribute(t));
  }) };
}
bt("unmount", function(e, t) {
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
    var u = t.__c;
    if (u) {
      u.__$f |= 8;
      var c = u.__$u;
      c && (u.__$u = void 0, c.d());
    }
  }
  e(t);
});
bt("__h", function(e, t, n, o) {
  o < 3 && (t.__$f |= 2), e(t, n, o);
});
vt.prototype.shouldComponentUpdate = function(e, t) {
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
  return Kn(function() {
    return g(e, t);
  }, []);
}
var Vs = typeof requestAnimationFrame > "u" ? setTimeout : function(e) {
  var t = function() {
    clearTimeout(n), cancelAnimationFrame(o), e();
  }, n = setTimeout(t, 35), o = requestAnimationFrame(t);
}, Is = function(e) {
  queueMicrotask(function() {
    queueMicrotask(e);
  });
};
function Rs() {
  qn(function() {
    for (var e; e = Li.shift(); ) Uo.call(e);
  });
}
function As() {
  Li.push(this) === 1 && (C.requestAnimationFrame || Vs)(Rs);
}
function Hs() {
  qn(function() {
    for (var e; e = Vi.shift(); ) Uo.call(e);
  });
}
function Ri() {
  Vi.push(this) === 1 && (C.requestAnimationFrame || Is)(Hs);
}
function Ai(e, t) {
  var n = ne(e);
  n.current = e;
  var o = Jt;
  Ce(function() {
    return L(function() {
      if (this.N = As, !(o && 8 & o.__$f)) return n.current();
    }, t);
  }, []);
}

// src/vec.ts
var V = (e, t) => [e[0] + t[0], e[1] + t[1], e[2] + t[2]], O = (e, t) => [e[0] - t[0], e[1] - t[1], e[2] - t[2]], _ = (e, t) => [e[0] * t, e[1] * t, e[2] * t], q = (e, t) => e[0] * t[0] + e[1] * t[1] + e[2] * t[2], ge = (e, t) => [
  e[1] * t[2] - e[2] * t[1],
  e[2] * t[0] - e[0] * t[2],
  e[0] * t[1] - e[1] * t[0]
], be = (e) => Math.hypot(e[0], e[1], e[2]), He = (e, t) => be(O(e, t)), Ks = (e, t, n) => V(_(e, 1 - n), _(t, n));
function ee(e, t = [0, 0, 1]) {
  let n = be(e);
  return n > 1e-12 ? _(e, 1 / n) : t;
}
function ot(e) {
  let t = Math.abs(e[0]) < 0.7 * be(e) ? [1, 0, 0] : [0, 1, 0];
  return ee(ge(t, e));
}
function Zt(e, t, n) {
  let o = Math.cos(n), r = Math.sin(n);
  return V(V(_(e, o), _(ge(t, e), r)), _(t, q(t, e) * (1 - o)));
}
function yt([e, t]) {
  return Array.from({ length: 8 }, (n, o) => [
    o & 1 ? t[0] : e[0],
    o & 2 ? t[1] : e[1],
    o & 4 ? t[2] : e[2]
  ]);
}
var Ue = ([e, t]) => Ks(e, t, 0.5);

// src/camera.ts
var jo = Math.PI / 180, jn = 89 * jo;
function _t(e, t, n) {
  let o = ee(O(e.target, e.eye), [0, 0, -1]), r = ee(ge(o, e.up), ot(o)), i = ge(r, o), a = e.height != null && e.height > 0, s = a ? e.height / n : 2 * Math.tan(e.fov * jo * 0.5) / n;
  return { eye: e.eye, forward: o, side: r, up: i, width: t, height: n, pixel: s, parallel: a };
}
function en(e, t) {
  let n = O(t, e.eye), o = q(n, e.forward), r = e.parallel ? e.pixel : e.pixel * o;
  return [e.width / 2 + q(n, e.side) / r, e.height / 2 - q(n, e.up) / r, o];
}
function Os(e, t, n) {
  let o = (t - e.width / 2) * e.pixel, r = (e.height / 2 - n) * e.pixel, i = V(_(e.side, o), _(e.up, r));
  return e.parallel ? { origin: V(e.eye, i), direction: e.forward } : { origin: e.eye, direction: ee(V(e.forward, i)) };
}
function Hi(e, t, n, o) {
  let r = O(e.target, e.eye), i = Math.max(be(r), 1e-3), a = Math.asin(Math.max(-1, Math.min(1, q(ee(r), t)))), s = O(r, _(t, q(r, t))), p = ee(be(s) > 1e-6 * i ? s : O(e.up, _(t, q(e.up, t))), ot(t)), u = Math.max(-jn, Math.min(jn, a + o)), c = Zt(p, t, n), d = V(_(c, Math.cos(u)), _(t, Math.sin(u)));
  return { ...e, up: t, target: V(e.eye, _(d, i)) };
}
function Ki(e, t, n, o, r) {
  let i = O(e.target, e.eye), a = O(i, _(t, q(i, t))), s = ee(be(a) > 1e-6 ? a : e.up, ot(t)), p = ee(ge(s, t)), u = V(V(_(s, n), _(p, o)), _(t, r));
  return Ke(e, u);
}
function Oi(e, t, n, o, r) {
  let i = ee(O(e.target, e.eye)), a = ee(ge(i, e.up), ot(i));
  return Ke(e, V(V(_(i, n), _(a, o)), _(t, r)));
}
function Ke(e, t) {
  return { ...e, eye: V(e.eye, t), target: V(e.target, t) };
}
function Di(e, t, n, o, r) {
  let i = ee(O(e.target, e.eye)), a = Math.asin(Math.max(-1, Math.min(1, q(i, t)))), s = Math.max(-jn, Math.min(jn, a + r)), p = ee(ge(i, t), ee(ge(i, e.up), ot(i))), u = (c) => Zt(Zt(c, p, s - a), t, o);
  return {
    ...e,
    up: t,
    eye: V(n, u(O(e.eye, n))),
    target: V(n, u(O(e.target, n)))
  };
}
function Fi(e, t, n, o, r) {
  let i = t.parallel ? t.pixel : t.pixel * r;
  return Ke(e, V(_(t.side, -n * i), _(t.up, o * i)));
}
function Wn(e, t, n, o, r) {
  let i = O(t, e.eye), a = be(i);
  if (a < 1e-9) return e;
  let s = a * (1 - n);
  return r ? s = Math.sign(s) * Math.max(Math.abs(s), 0.5 * Math.abs(1 - n)) : s > 0 && (s = Math.max(0, Math.min(s, a - o))), Ke(e, _(i, s / a));
}
function Bn(e, t, n, o, r) {
  let i = Math.max(0.05, Math.min(1e5, (e.height ?? 1) * r)), a = (1 - i / (e.height ?? 1)) * t.pixel, s = V(
    _(t.side, (n - t.width / 2) * a),
    _(t.up, (t.height / 2 - o) * a)
  );
  return { ...Ke(e, s), height: i };
}
function Ni(e, t, n = 0.4) {
  let o = Ue(t), r = Math.max(He(t[0], t[1]) / 2, 0.5), i = ee(O(e.eye, e.target));
  if (e.height) {
    let s = q(O(e.eye, o), i);
    return { ...e, eye: V(o, _(i, s)), target: o, height: r * 3 };
  }
  let a = Math.max(1.5 * r / Math.tan(e.fov * jo * 0.5), n + r);
  return { ...e, eye: V(o, _(i, a)), target: o };
}
var Ds = ["plan", "ceiling", "north", "east", "south", "west"];
function qi(e) {
  let t = Math.abs(e[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], n = ee(ge(e, t));
  return { right: ee(ge(n, e)), ahead: n };
}
function Ui(e, t, n, o) {
  let { right: r, ahead: i } = qi(n), a = Ue(t), s = (b) => Math.abs(q(O(t[1], t[0]), b)), u = {
    plan: { forward: _(n, -1), up: i, side: r, cut: 0.15 },
    ceiling: { forward: n, up: _(i, -1), side: r, cut: 0.35 },
    north: { forward: i, up: n, side: r, cut: 0.25 },
    south: { forward: _(i, -1), up: n, side: r, cut: 0.25 },
    east: { forward: r, up: n, side: i, cut: 0.25 },
    west: { forward: _(r, -1), up: n, side: i, cut: 0.25 }
  }[e], c = s(u.forward), d = 1, m = O(a, _(u.forward, c / 2 + d)), f = 1.08 * Math.max(s(u.up), s(u.side) / o, 0.1);
  return { eye: m, target: a, up: u.up, fov: 50, height: f, near: d + c * u.cut };
}
function tn(e, t) {
  let n = (r, i) => He(r, i) < 1e-4, o = (r, i) => Math.abs((r ?? -1) - (i ?? -1)) < 1e-4;
  return n(e.eye, t.eye) && n(e.target, t.target) && n(e.up, t.up) && o(e.fov, t.fov) && o(e.height, t.height) && o(e.near, t.near);
}

// src/counters.ts
var ie = {
  frame: 0,
  seqApplied: 0,
  frames: [],
  sent: [],
  entered: 0,
  firstDrawn: 0
}, ji = 0;
for (let e of ["input", "pointermove", "pointerdown", "keydown", "wheel"])
  addEventListener(e, (t) => ji = t.timeStamp, { capture: !0, passive: !0 });
function Wi(e, t) {
  ie.sent.push({ seq: e, what: t, at: performance.now(), input: ji }), ie.sent.length > 1024 && ie.sent.shift();
}
function Bi(e) {
  ie.frame = e.frame, ie.seqApplied = e.seq, ie.firstDrawn ||= e.drawn, ie.frames.push(e), ie.frames.length > 1024 && ie.frames.shift(), requestAnimationFrame(() => {
    let t = new MessageChannel();
    t.port1.onmessage = () => {
      e.painted = performance.now(), t.port1.close();
    }, t.port2.postMessage(0);
  });
}
window.__desk = ie;

// src/store.ts
var Gn = /* @__PURE__ */ new Set(), wt = (e) => typeof e == "object" && e !== null && !Array.isArray(e);
function rn(e, t) {
  if (!wt(e) || !wt(t)) return t;
  let n = { ...e };
  for (let [o, r] of Object.entries(t)) n[o] = rn(n[o], r);
  return n;
}
var nn = class {
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
      this.own.set(o, { value: rn(i, r), seq: n });
    }
    Gn.add(this), this.show();
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
    this.own.size === 0 && Gn.delete(this), n && this.show();
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
function Gi(e) {
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
    for (let [o, r] of Object.entries(t ?? {})) n.set(Number(o), new nn(r));
    this.entries = n, this.number();
  }
  patch(t) {
    let n = !1;
    for (let [o, r] of Object.entries(t)) {
      let i = Number(o), a = this.entries.get(i);
      r === null ? n = this.entries.delete(i) || n : a ? (Gi(a.shown.peek()) !== Gi(r) && this.order.value++, a.receive(r)) : (this.entries.set(i, new nn(r)), n = !0);
    }
    n && this.number();
  }
  number() {
    this.ids.value = [...this.entries.keys()].sort((t, n) => t - n);
  }
}, k = new Ee(), D = new Ee(), ye = new Ee(), kt = new Ee(), xt = new Ee(), St = new Ee(), Mt = new Ee(), zn = new Ee(), on = {
  lamps: k,
  groups: D,
  things: ye,
  materials: kt,
  views: xt,
  looks: St,
  meters: Mt,
  grids: zn
}, te = g(null), an = g([]), _e = g([]), rt = g({ undo: null, redo: null, steps: 0 }), it = g({ state: "clean", file: "" }), F = g({ you: !0, name: null }), Te = g(null), Xn = new nn({
  ev: null,
  metered: !1,
  tone: "filmic",
  white: null,
  false_color: null
}), at = Xn.shown, Wo = {
  scene: te,
  layers: an,
  solo: _e,
  history: rt,
  saved: it,
  editor: F,
  status: Te
};
function zi(e) {
  Gn.clear();
  for (let [t, n] of Object.entries(on)) n.whole(e[t]);
  for (let [t, n] of Object.entries(Wo)) t in e && (n.value = e[t]);
  wt(e.display) && Xn.receive(e.display);
}
function Xi(e, t) {
  for (let [n, o] of Object.entries(e))
    n in on ? on[n].patch(o) : n === "display" ? Xn.receive(o) : n in Wo && (Wo[n].value = o);
  Ct(t);
}
function Ct(e) {
  for (let t of [...Gn]) t.release(e);
}
function Yi(e, t) {
  for (let [n, o] of Object.entries(e))
    if (n in on && wt(o))
      for (let [r, i] of Object.entries(o)) {
        let a = on[n].entry(Number(r));
        a && wt(i) && t(a, i);
      }
    else n === "display" && wt(o) && t(Xn, o);
}
var Bo = (e, t) => Yi(e, (n, o) => n.keep(o, t)), Yn = (e, t) => Yi(e, (n, o) => n.settle(o, t));
function sn(e) {
  let t = D.get(e.group);
  return e.on && !e.parked && (t?.on ?? !0) ? e.level * (t?.level ?? 1) : 0;
}
function Go(e) {
  return e.reduce((t, n) => {
    let o = k.get(n);
    return t + (o ? o.flux * sn(o) : 0);
  }, 0);
}
var Qi = N(() => {
  let e = k.all();
  return e.length > 0 && e.every(([, t]) => sn(t) === 0);
});
function Fs(e, t) {
  let n = t.trim().toLowerCase();
  return e.all().filter(([, o]) => !n || o.name.toLowerCase().includes(n));
}

// src/wire.ts
var j = g("entering"), cn = g(0), pe = g("edit"), Qn = g(null), Oe = g(0), Ji = () => null, Zi = (e) => {
  Ji = e;
}, Jn = /* @__PURE__ */ new Map(), je = null, ln = 0, zo = null, un = 0, Et = "", Zn = !1;
function Se(e, t) {
  let n = Jn.get(e) ?? /* @__PURE__ */ new Set();
  return Jn.set(e, n.add(t)), () => n.delete(t);
}
function K(e) {
  return !je || je.readyState !== WebSocket.OPEN || j.peek() !== "open" ? 0 : (ln += 1, je.send(JSON.stringify({ ...e, seq: ln })), e.do !== "ack" && Wi(ln, e.do), ln);
}
var Ns = 0, st = /* @__PURE__ */ new Map();
function De(e, t, n, o = () => {
}) {
  let r = ++Ns, i = Se("answer", (s) => {
    s.id === r && (s.done !== !1 && i(), n(s));
  }), a = K({ do: "ask", id: r, what: e, ...t });
  if (!a)
    return i(), o("There is no connection to the program."), i;
  st.set(a, (s) => {
    i(), o(s);
  });
  for (let s of st.keys()) {
    if (s > a - 300) break;
    st.delete(s);
  }
  return i;
}
function qs(e) {
  switch (e.is) {
    case "hello":
      if (un = 0, zo !== null && e.build !== zo) {
        j.value = "renewed", je?.close();
        return;
      }
      zo = e.build, pe.value = e.role === "watch" ? "watch" : "edit", Qn.value = e.you === void 0 ? null : String(e.you), Oe.value = 0, st.clear(), j.value = "open";
      break;
    case "state":
      zi(e.state ?? e);
      break;
    case "patch":
      (e.by == null || String(e.by) === Qn.value) && Xo(e.seq), Xi(e.patch ?? {}, Oe.value);
      break;
    case "status":
      Te.value = e;
      break;
    case "refused":
      if (Xo(e.seq), Ct(Oe.value), st.has(e.seq)) {
        st.get(e.seq)?.(e.why ?? ""), st.delete(e.seq);
        return;
      }
      break;
    case "event":
      e.what === "bye" && (Zn = !0);
      break;
  }
  for (let t of [...Jn.get(e.is) ?? []]) t(e);
}
function Xo(e) {
  typeof e == "number" && e > Oe.value && (Oe.value = e);
}
async function ea() {
  if (!Et) return "in";
  try {
    return (await fetch("/enter", {
      method: "POST",
      headers: { "content-type": "application/json" },
      body: JSON.stringify({ key: Et })
    })).ok ? "in" : "denied";
  } catch {
    return "away";
  }
}
function ta() {
  let e = location.protocol === "https:" ? "wss" : "ws", t = new WebSocket(`${e}://${location.host}/wire`);
  t.binaryType = "arraybuffer";
  let n = !1;
  je = t, Jn.get("line")?.forEach((o) => o({ is: "line" })), t.onmessage = (o) => {
    if (t !== je) return;
    if (typeof o.data != "string") {
      let i = Ji(o.data);
      i && F.value.you && Xo(i.seq);
      return;
    }
    let r = JSON.parse(o.data);
    r.is === "hello" && (n = !0, ln = 0), qs(r);
  }, t.onclose = () => {
    t === je && (je = null, j.value !== "renewed" && Us(n));
  };
}
async function Us(e) {
  if (Ct(1 / 0), !e && await js()) {
    let o = await ea();
    if (o === "denied" || o === "in" && un > 4 && !Et) {
      j.value = "denied";
      return;
    }
  }
  un += 1;
  let t = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
  un > 3 && t && (Zn = !0), j.value = Zn ? "ended" : "lost";
  let n = Math.min(5, un);
  for (let o = n; o > 0; o--)
    cn.value = o, await new Promise((r) => setTimeout(r, 1e3));
  cn.value = 0, ta();
}
async function js() {
  try {
    return await fetch("/", { cache: "no-store" }), !0;
  } catch {
    return !1;
  }
}
async function na() {
  let e = location.hash.slice(1);
  if (e ? (Et = e, sessionStorage.setItem("lampyris-key", Et), window.history.replaceState(null, "", location.pathname + location.search)) : Et = sessionStorage.getItem("lampyris-key") ?? "", ie.entered = performance.now(), e && await ea() === "denied") {
    j.value = "denied";
    return;
  }
  ta();
}
Se("hello", () => Zn = !1);

// src/frames.ts
var W = g(null), Pt = g(0), oa = ["moving", "settled", "final"], ra = 32, Tt = /* @__PURE__ */ new Map(), Pe = null, Yo = null, Qo = !1, lt = null;
function Ws(e) {
  if (e.byteLength < ra) return null;
  let t = new DataView(e);
  return { head: {
    frame: t.getUint32(0, !0),
    seq: t.getUint32(4, !0),
    camera: t.getUint32(8, !0),
    width: t.getUint16(12, !0),
    height: t.getUint16(14, !0),
    kind: oa[Math.min(t.getUint8(16), 2)],
    falseColor: (t.getUint8(18) & 1) === 1,
    batches: t.getUint32(20, !0),
    error: t.getFloat32(24, !0),
    light: t.getUint16(28, !0) / 10,
    encode: t.getUint16(30, !0) / 10
  }, mime: t.getUint8(17) === 1 ? "image/png" : "image/jpeg" };
}
function Bs(e) {
  let t = Ws(e);
  return t ? (lt && K({ do: "ack", frame: lt.head.frame }), lt = { ...t, bytes: e, received: performance.now() }, Qo || Gs(), t.head) : null;
}
async function Gs() {
  for (Qo = !0; lt; ) {
    let { head: e, mime: t, bytes: n, received: o } = lt;
    lt = null;
    try {
      let r = await createImageBitmap(new Blob([new Uint8Array(n, ra)], { type: t }));
      zs(e, r, n.byteLength, o);
    } catch {
    }
    K({ do: "ack", frame: e.frame });
  }
  Qo = !1;
}
function zs(e, t, n, o) {
  let r = performance.now();
  Pe && Yo && ((Pe.width !== t.width || Pe.height !== t.height) && (Pe.width = t.width, Pe.height = t.height), Yo.drawImage(t, 0, 0)), t.close();
  let i = Tt.get(e.camera) ?? W.peek()?.camera;
  i && (W.value = { head: e, camera: i }), Xs(), Bi({
    frame: e.frame,
    seq: e.seq,
    kind: oa.indexOf(e.kind),
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
var eo = [];
function Xs() {
  let e = performance.now();
  eo = eo.filter((t) => e - t < 1e3), eo.push(e), Pt.value = eo.length;
}
function Jo(e) {
  Pe = e, Yo = e?.getContext("2d", { alpha: !1 }) ?? null;
}
function ia() {
  if (!Pe || !W.peek()) return null;
  let e = document.createElement("canvas");
  return e.width = Pe.width, e.height = Pe.height, e.getContext("2d", { alpha: !1 })?.drawImage(Pe, 0, 0), e;
}
Zi(Bs);
Se("camera", (e) => {
  Tt.set(e.number, e);
  for (let t of Tt.keys()) {
    if (Tt.size <= 64) break;
    Tt.delete(t);
  }
});
Se("line", () => {
  Tt.clear(), lt = null;
});

// src/prefs.ts
var aa = "lampyris-";
function ae(e, t) {
  let n = t;
  try {
    let r = localStorage.getItem(aa + e);
    r !== null && (n = JSON.parse(r));
  } catch {
  }
  let o = g(n);
  return L(() => {
    let r = JSON.stringify(o.value);
    try {
      localStorage.setItem(aa + e, r);
    } catch {
    }
  }), o;
}
var Zo = ae("theme", "dark"), er = ae("house-lights", 1), to = ae("hands", "default"), tr = ae("walking", "walk"), nr = ae("panels", !0), $t = ae("listing", "faders"), no = ae("travel", "square"), Lt = ae("candles", "lx"), or = ae("single-keys", !0), rr = ae("lamp-marks", !0), fn = ae("maintenance", 1), Ys = ae("work-plane", 0.75), We = ae("fine", !1), ir = ae("fade", 1), Qs = typeof matchMedia == "function" && matchMedia("(pointer: coarse)").matches, we = ae("look-only", Qs);

// src/say.ts
var ut = g([]), Js = 0;
function se(e, t = "plain") {
  if (ut.peek().find((r) => r.text === e)) return;
  let o = ++Js;
  ut.value = [...ut.peek().slice(-2), { id: o, text: e, tone: t }], setTimeout(() => ar(o), t === "warn" ? 8e3 : 4e3);
}
function ar(e) {
  ut.value = ut.peek().filter((t) => t.id !== e);
}

// src/gesture.ts
var Vt = 0, ua = /* @__PURE__ */ new Set(), ca = (e) => {
  ua.add(e);
}, pn = /* @__PURE__ */ new Set(), Ge = N(() => we.value ? "The look-only lock is on." : pe.value === "watch" ? "You are watching. Ask for the pen to change things." : F.value.you ? null : `${F.value.name ?? "Somebody else"} has the pen. Take it to change things.`);
function oo() {
  return j.value !== "open" ? "There is no connection to the program: nothing was changed." : Ge.value;
}
var sa = (e) => (e.length > 120 ? `${e.slice(0, 119)}…` : e).replace(/[\u0000-\u001f]/g, " "), Be = class {
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
    this.state === "over" || !this.begin() || (Bo(t, 1 / 0), this.touched = rn(this.touched, t), this.waiting = rn(this.waiting ?? {}, t), this.under <= Oe.peek() && this.flush());
  }
  /** Any other message that belongs to this step. */
  also(t) {
    this.state === "over" || !this.begin() || (this.flush(), this.last = K(t));
  }
  end(t) {
    this.state === "held" && (this.flush(), Yn(this.touched, this.last), this.finish({ do: "end", ...t ? { label: sa(t) } : {} })), this.state = "over";
  }
  cancel() {
    this.state === "held" && (this.waiting = null, Yn(this.touched, 0), this.finish({ do: "cancel" }), Ct(0)), this.state = "over";
  }
  /** The server has followed so far. */
  followed() {
    this.waiting && this.under <= Oe.peek() && this.flush();
  }
  /** The line is gone, and with it what was held. */
  drop() {
    this.state = "over", pn.delete(this), Vt = 0;
  }
  begin() {
    if (this.state === "held") return !0;
    let t = ue(oo);
    return t ? (se(t, "warn"), this.state = "over", !1) : (this.state = "held", pn.add(this), Vt === 0 && ua.forEach((n) => n()), Vt++ === 0 && (this.last = K({ do: "begin", label: sa(this.label) })), !0);
  }
  flush() {
    this.waiting && (this.under = this.last = K({ do: "set", patch: this.waiting }), this.waiting = null);
  }
  finish(t) {
    pn.delete(this), Vt = Math.max(0, Vt - 1), Vt === 0 && K(t);
  }
};
function Le(e, t) {
  let n = new Be(e);
  n.set(t), n.end();
}
function Zs(e, t) {
  let n = new Be(e);
  n.also(t), n.end();
}
function It(e) {
  ue(() => j.value) === "open" && (Bo({ display: e }, 1 / 0), Yn({ display: e }, K({ do: "display", patch: e })));
}
var $e = null;
function sr(e, t, n) {
  $e && $e.key !== e && la(), $e ??= { key: e, gesture: new Be(t), timer: 0 }, $e.gesture.set(n), clearTimeout($e.timer), $e.timer = window.setTimeout(la, 700);
}
function la() {
  $e && (clearTimeout($e.timer), $e.gesture.end(), $e = null);
}
L(() => {
  Oe.value, ue(() => [...pn].forEach((e) => e.followed()));
});
L(() => {
  j.value !== "open" && [...pn].forEach((e) => e.drop());
});

// src/before.ts
var dn = g(null), de = g(null), el = g(0.5);
function tl() {
  let e = W.peek(), t = ia();
  e && t && (dn.value = { picture: t, camera: e.camera });
}
function lr() {
  de.peek() !== "wipe" && tl();
}
ca(lr);
function fa() {
  let e = dn.peek(), t = W.peek();
  if (!e || !t) se("Nothing has been changed yet.");
  else if (!tn(e.camera, t.camera)) se("The picture before was taken from another place: go back there with Alt+←.", "warn");
  else return !0;
  return !1;
}
function mn(e) {
  e ? de.peek() === null && fa() && (de.value = "held") : de.peek() === "held" && (de.value = null);
}
function nl() {
  de.value = de.peek() === "wipe" ? null : fa() ? "wipe" : null;
}

// src/select.ts
var E = g(null), me = g(null), X = g(null), ol = g("move"), le = N(() => {
  let e = E.value;
  return e?.kind === "lamp" ? e.ids.filter((t) => k.has(t)) : e?.kind === "group" ? e.ids.flatMap((t) => D.get(t)?.lamps ?? []) : [];
});
function ze(e, t, n = "only") {
  let o = E.peek();
  if (n === "only" || o?.kind !== e) {
    E.value = { kind: e, ids: [t] };
    return;
  }
  let r = o.ids.includes(t);
  if (r && n === "add") return;
  let i = r ? o.ids.filter((a) => a !== t) : [...o.ids, t];
  E.value = i.length ? { kind: e, ids: i } : null;
}
function ro() {
  E.value = null;
}
function pa(e, t, n) {
  let o = E.peek(), r = o?.kind === e ? t.indexOf(o.ids[o.ids.length - 1]) : -1;
  if (r < 0) return ze(e, n);
  let i = t.indexOf(n), [a, s] = r < i ? [r, i] : [i, r], p = t.slice(a, s + 1), u = (o?.ids ?? []).filter((c) => !p.includes(c));
  E.value = { kind: e, ids: [...u, ...r < i ? p : p.reverse()] };
}
function rl(e) {
  let t = E.peek(), n = t?.kind ?? "lamp", o = n === "lamp" ? k.ids.peek() : n === "thing" ? ye.ids.peek() : D.ids.peek();
  if (!o.length) return;
  let r = t ? o.indexOf(t.ids[t.ids.length - 1]) : e > 0 ? -1 : 0;
  ze(n, o[(r + e + o.length) % o.length]);
}
function da(e, t) {
  switch (e) {
    case "lamp":
      return k.get(t)?.name ?? `lamp ${t}`;
    case "group":
      return D.get(t)?.name ?? `group ${t}`;
    case "thing":
      return ye.get(t)?.name ?? `thing ${t}`;
    case "material":
      return kt.get(t)?.name ?? `material ${t}`;
    default:
      return `${e} ${t}`;
  }
}
function io(e) {
  return e.length === 1 ? da("lamp", e[0]) : `${e.length} lamps`;
}
function ma(e, t) {
  let n = [];
  if (e?.lamp != null) {
    n.push({ kind: "lamp", ids: [e.lamp] });
    let i = k.get(e.lamp)?.group;
    i != null && (D.get(i)?.lamps.length ?? 0) > 1 && n.push({ kind: "group", ids: [i] });
  }
  if (e?.thing != null && n.push({ kind: "thing", ids: [e.thing] }), !n.length) {
    t === "only" && ro();
    return;
  }
  if (t !== "only") return ze(n[0].kind, n[0].ids[0], t);
  let o = E.peek(), r = n.findIndex((i) => o?.kind === i.kind && o.ids.length === 1 && o.ids[0] === i.ids[0]);
  E.value = n[(r + 1) % n.length];
}
var hn = g(null);

// src/navigate.ts
var va = 1.6, he = g(null), ga = N(() => pe.value === "edit" && F.value.you), Ve = N(() => te.value?.up ?? [0, 0, 1]), ke = g([640, 480]), Ht = g(null), fr = null, vn = null, ur = !1, Xe = [], dr = [], pr = 0;
function J(e, t = null) {
  let n = he.peek();
  if (n && tn(n, e)) return;
  let o = performance.now();
  n && (o - pr > 1e3 || t) && (Xe.push(n), Xe.length > 100 && Xe.shift(), dr.length = 0), pr = o, he.value = e, Ht.value = t;
}
var oe = () => he.peek();
function il() {
  ba(Xe, dr);
}
function al() {
  ba(dr, Xe);
}
function ba(e, t) {
  let n = e.pop();
  if (!n) return;
  let o = he.peek();
  o && t.push(o), pr = performance.now(), he.value = n, Ht.value = null;
}
L(() => {
  !he.value || j.value !== "open" || !ga.value || ur || (ur = !0, requestAnimationFrame(() => {
    ur = !1;
    let t = he.peek();
    if (!t || vn && tn(vn, t)) return;
    let { eye: n, target: o, up: r, fov: i, height: a, near: s } = t, p = { do: "camera", eye: n, target: o, up: r, fov: i };
    a && (p.height = a), s && (p.near = s), K(p) && (vn = t);
  }));
});
L(() => {
  let e = W.value;
  e && ue(() => {
    he.peek() && ga.peek() || (vn = e.camera, he.value = e.camera, fr ??= e.camera);
  });
});
Se("hello", () => vn = null);
function Kt(e, t) {
  let n = W.peek();
  if (!n) return null;
  let { head: o } = n, r = gn(o.width, o.height);
  return { frame: o.frame, x: (e - r.x) / r.scale, y: (t - r.y) / r.scale };
}
function gn(e, t) {
  let [n, o] = ke.peek(), r = Math.min(n / e, o / t);
  return { x: (n - e * r) / 2, y: (o - t * r) / 2, scale: r };
}
function ct(e = he.peek()) {
  let [t, n] = ke.peek();
  return e ? _t(e, t, n) : null;
}
var At = () => te.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]], Ot = () => Ue(At());
function ao(e, t) {
  let n = oe();
  n && J(Hi(n, Ve.peek(), e, t));
}
function so(e, t, n) {
  let o = oe();
  o && J(Di(o, Ve.peek(), e, t, n));
}
function Dt(e, t, n) {
  let o = oe(), r = ct();
  o && r && J(Fi(o, r, e, t, n));
}
function ya(e, t, n) {
  let o = oe();
  if (o) {
    if (o.height) {
      let r = ct(o);
      r && J(Ke(o, V(_(r.side, t), _(r.up, e))));
      return;
    }
    tr.peek() === "fly" || n !== 0 ? J(Oi(o, Ve.peek(), e, t, n)) : (J(Ki(o, Ve.peek(), e, t, 0)), sl());
  }
}
var Rt = !1, cr = !0, ha = null;
function sl() {
  let e = oe();
  if (!e || Rt || !cr) return;
  let t = Ve.peek();
  Rt = !0;
  let n = De("ray", { origin: e.eye, direction: _(t, -1) }, (o) => {
    Rt = !1, cr = !0;
    let r = oe();
    if (!o.hit || !r || r.height) return;
    ha = q(o.point, t);
    let i = ha + va - q(r.eye, t);
    Math.abs(i) > 0.01 && J(Ke(r, _(t, i * 0.5)));
  }, () => {
    Rt = !1, cr = !1;
  });
  setTimeout(() => {
    Rt && n(), Rt = !1;
  }, 500);
}
function ll() {
  let e = E.peek();
  if (!e) return null;
  let t = [], n = (i, a) => {
    i ? t.push(i) : a && t.push([a, a]);
  };
  for (let i of e.ids)
    if (e.kind === "lamp" && n(k.get(i)?.box, k.get(i)?.place?.position), e.kind === "thing" && n(ye.get(i)?.box), e.kind === "meter" && n(null, Mt.get(i)?.point), e.kind === "group")
      for (let a of D.get(i)?.lamps ?? []) n(k.get(a)?.box, k.get(a)?.place?.position);
  if (!t.length) return null;
  let o = t.flatMap(yt), r = (i) => [0, 1, 2].map((a) => i(...o.map((s) => s[a])));
  return [r(Math.min), r(Math.max)];
}
function ul() {
  let e = oe(), t = ll();
  e && t ? J(Ni(e, t), "selection") : mr();
}
function mr() {
  fr && J(fr, "home");
}
function cl(e) {
  let [t, n] = ke.peek();
  J(Ui(e, At(), Ve.peek(), t / n), e);
}
function fl() {
  for (let e = Xe.length - 1; e >= 0; e--)
    if (!Xe[e].height) return J(Xe[e], "inside");
  mr();
}
var pl = N(() => {
  let e = he.value;
  if (!e?.height) return null;
  let t = _t(e, 2, 2), n = yt(At()).map((s) => q(O(s, e.eye), t.forward)), o = e.near ?? 0, r = q(t.forward, Ve.value), i = Math.min(...yt(At()).map((s) => q(s, Ve.value))), a = Math.abs(r) > 0.99 ? q(e.eye, Ve.value) + r * o - i : null;
  return { value: o, most: Math.max(...n), height: a };
});
function dl(e) {
  let t = oe();
  t && (he.value = { ...t, near: Math.max(0, e) });
}

// src/tools.ts
var hr = g("spot"), _a = () => {
}, ml = (e) => {
  _a = e;
}, wa = (e) => _a(e);
function vr(e) {
  X.value = X.peek() === e ? null : e;
}
var lo = (e) => Math.max(-1, ...e.ids.peek()) + 1;
function gr(e) {
  return e.kind === "sky" || e.kind === "parallel" ? null : e.place?.position ?? (e.box ? Ue(e.box) : null);
}

// src/actions.ts
var ft = g(null), Ie = g("lamps"), br = g("");
function co(e) {
  let t = oo();
  if (t) return se(t, "warn");
  (e.do === "look" ? e.what === "recall" : e.do !== "save") && lr(), K(e);
}
var hl = (e, t) => Object.fromEntries(e.map((n) => [n, t])), yr = {
  quantity: "illuminance",
  low: 1,
  high: 1e3,
  scale: "log",
  palette: "even",
  lines: !1
}, bn = yr, ka = ({ quantity: e, low: t, high: n, scale: o, palette: r, lines: i, against: a }) => ({ quantity: e, low: t, high: n, scale: o, palette: r, lines: i, against: a }), vl = () => at.peek().false_color ?? bn;
function _r() {
  let e = at.peek().false_color;
  e && (bn = e), bn.against != null && (bn = yr), It({ false_color: e ? null : ka(bn) });
}
function fo(e) {
  let t = Math.round(((at.peek().ev ?? 0) + e / 3) * 30) / 30;
  It({ ev: t });
}
function gl() {
  let e = oe();
  if (!e) return;
  let t = lo(xt);
  Le("Store the view", { views: { [t]: { ...e, name: `View ${t + 1}` } } });
}
var bl = () => co({ do: "look", what: "store", name: `Look ${lo(St) + 1}` });
async function wr(e) {
  let t = !1;
  try {
    await navigator.clipboard.writeText(e), t = !0;
  } catch {
    let n = document.createElement("textarea");
    n.value = e, n.className = "spoken", document.body.append(n), n.select(), t = document.execCommand("copy"), n.remove();
  }
  se(t ? "Copied." : `Copy it by hand: ${e}`);
}
var Ft = /* @__PURE__ */ new Map(), uo = null;
function yl(e) {
  Ft = new Map(e.map((t) => [t.id, t])), uo && B(uo), uo = null;
}
var _l = () => [...Ft.values()], xa = (e) => Ft.get(e), yn = (e) => Ft.get(e)?.why?.() ?? null;
function B(e) {
  let t = Ft.get(e);
  Ft.size || (uo = e);
  let n = t?.why?.();
  n ? se(n, "warn") : t?.run();
}

// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var wl = /* @__PURE__ */ Symbol.for("pv"), kl = 0;
function l(e, t, n, o, r, i) {
  t || (t = {});
  var a, s, p = t;
  if ("ref" in p && typeof e != "function") for (s in p = {}, t) s == "ref" ? a = t[s] : p[s] = t[s];
  var u = { type: e, props: p, key: n, ref: a, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: wl, __v: --kl, __i: -1, __u: 0 };
  return (r || i) && (u.__source = r, u.__self = i), C.vnode && C.vnode(u), u;
}

// src/load.tsx
var Ma = g(null), kr = !1, Sa = 0, xr = (e) => Ma.value?.[e];
function Z({ part: e }) {
  let t = xr(e);
  return t ? l(t, {}) : null;
}
function Ca() {
  L(() => {
    if (kr || !(W.value ?? E.value)) return;
    kr = !0;
    let e = `./gizmo.js${Sa++ ? `?${Sa}` : ""}`;
    setTimeout(() => {
      import(e).then((t) => Ma.value = t, () => kr = !1);
    }, 0);
  });
}

// src/units.ts
var po = 0.3048, Ea = {
  level: { bare: 0.01, units: { "%": 0.01, x: 1, "×": 1 }, low: 0, high: 1e3, say: "a level such as 80 % or 450 lm" },
  flux: { bare: 1, units: { lm: 1, klm: 1e3 }, low: 0, high: 1e9, say: "a flux such as 450 lm" },
  kelvin: { bare: 1, units: { k: 1 }, low: 1e3, high: 25e3, say: "a colour temperature such as 2700 K" },
  angle: { bare: 1, units: { "°": 1, deg: 1, rad: 180 / Math.PI }, low: -36e3, high: 36e3, say: "an angle such as 30°" },
  length: {
    bare: 1,
    units: { m: 1, cm: 0.01, mm: 1e-3, km: 1e3, ft: po, "'": po, in: po / 12, '"': po / 12 },
    low: -1e6,
    high: 1e6,
    say: `a length such as 2.4 m, 75 cm or 8'2"`
  },
  lux: { bare: 1, units: { lx: 1, klx: 1e3, fc: 10.7639 }, low: 0, high: 1e9, say: "an illuminance such as 500 lx" },
  share: { bare: 1, units: { "%": 0.01 }, low: 0, high: 1, say: "a share from 0 to 1 or 0 to 100 %" },
  number: { bare: 1, units: {}, low: -1e9, high: 1e9, say: "a number" },
  ev: { bare: 1, units: { ev: 1, stop: 1, stops: 1 }, low: -30, high: 30, say: "an exposure such as 8.3" },
  seconds: { bare: 1, units: { s: 1, ms: 1e-3, min: 60 }, low: 0, high: 3600, say: "a time such as 2 s" }
}, xl = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;
function Sr(e) {
  let t = xl.exec(e);
  if (!t) return null;
  let [n, o] = t[0].split("/").map(Number);
  return o === 0 ? null : { value: o === void 0 ? n : n / o, rest: e.slice(t[0].length).trimStart() };
}
function Ta(e, t, n) {
  let o = e.trim(), r = 0, i = !0;
  for (; o; ) {
    let a = 1, s = /^[+-]\s*/.exec(o);
    s && !i && (a = o[0] === "-" ? -1 : 1, o = o.slice(s[0].length));
    let p = Sr(o);
    if (!p) return null;
    let u = /^[a-zµ°%'"×]+/i.exec(p.rest)?.[0] ?? "", c = u === "" ? n : t.units[u.toLowerCase()];
    if (c === void 0) return null;
    r += a * p.value * c, o = p.rest.slice(u.length).trim(), i = !1;
  }
  return i ? null : r;
}
function Pa(e, t, n) {
  let o = Ea[t], r = e.trim().replace(/,(?=\d)/g, ".").replace(/[\u2009\u202f\u00a0]/g, "").replace(/−/g, "-"), i = { why: `“${e.trim()}” is not ${o.say}` }, a = (y) => ({
    apply: (x) => Math.min(o.high, Math.max(o.low, y(x)))
  });
  if (!r) return { why: `Type ${o.say}` };
  let s = r.toLowerCase();
  if (t === "level" && s === "full") return a(() => 1);
  if (t === "level" && (s === "out" || s === "off")) return a(() => 0);
  let p = /^(.*?)\s*(?:stops?|ev)$/i.exec(r);
  if (p && t !== "ev") {
    let y = Sr(p[1].trim());
    return !y || y.rest || !["level", "flux", "lux", "number"].includes(t) ? i : a((x) => x * 2 ** y.value);
  }
  let u = /^([*/×÷])\s*(.+)$/.exec(r);
  if (u) {
    let y = Sr(u[2]);
    if (!y) return i;
    let x = y.rest === "%" ? 0.01 : y.rest === "" ? 1 : NaN, S = y.value * x;
    return !Number.isFinite(S) || S === 0 && /[/÷]/.test(u[1]) ? i : a((w) => /[/÷]/.test(u[1]) ? w / S : w * S);
  }
  let d = t === "length" || t === "angle" || t === "ev" || t === "number" ? /^([+-])=\s*(.+)$/.exec(r) : /^([+-])=?\s*(.+)$/.exec(r), m = d ? d[2] : r, f = Ta(m, o, o.bare);
  if (f === null && t === "level" && n) {
    let y = Ta(m, { ...Ea.flux }, NaN);
    f = y === null || Number.isNaN(y) ? null : y / n;
  }
  if (f === null || !Number.isFinite(f)) return i;
  let b = f;
  return d ? a((y) => d[1] === "-" ? y - b : y + b) : b < o.low || b > o.high ? { why: `${e.trim()} is out of range: ${o.say}` } : a(() => b);
}
function G(e, t = 0) {
  if (!Number.isFinite(e)) return "–";
  let [n, o] = Math.abs(e).toFixed(t).split("."), r = n.length > 4 ? n.replace(/\B(?=(\d{3})+$)/g, " ") : n;
  return (e < 0 && Number(Math.abs(e).toFixed(t)) !== 0 ? "−" : "") + r + (o ? `.${o}` : "");
}
function Ye(e) {
  let t = Math.abs(e);
  return G(e, t >= 99.95 || t === 0 ? 0 : t >= 9.995 ? 1 : t >= 0.9995 ? 2 : 3);
}
function Re(e) {
  let t = e * 100;
  return G(t, t >= 9.95 || t === 0 ? 0 : t >= 0.95 ? 1 : 2);
}
function _n(e, t) {
  switch (t) {
    case "level":
      return `${Re(e)} %`;
    case "flux":
      return `${Ye(e)} lm`;
    case "kelvin":
      return `${G(e)} K`;
    case "angle":
      return `${G(e, 1)}°`;
    case "length":
      return `${G(e, 2)} m`;
    case "lux":
      return `${Ye(e)} lx`;
    case "seconds":
      return `${G(e, 1)} s`;
    case "ev":
      return G(e, 1);
    case "share":
      return G(e, 2);
    case "number":
      return String(Math.round(e * 1e4) / 1e4);
  }
}
var Mr = (e) => (e > 0 ? "+" : "") + Cr(e);
function Cr(e, t = !0) {
  let n = Lt.value === "fc", o = n ? e / 10.7639 : e;
  return Ye(o) + (t ? n ? " fc" : " lx" : "");
}
var pt = (e, t = !0) => Cr(e * fn.value, t);

// src/field.tsx
function wn(e) {
  let t = nt(null), n = nt(null), o = ne(null), r = ne(null), i = t.value ?? e.text ?? (e.value === null ? "mixed" : _n(e.value, e.quantity));
  Ce(() => {
    !e.open || !o.current || (t.value = e.open, o.current.focus(), o.current.setSelectionRange(e.open.length, e.open.length), e.opened?.());
  }, [e.open]);
  let a = () => {
    if (t.value === null) return;
    let d = Pa(t.value, e.quantity, e.flux);
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
  }, u = (d) => {
    let m = r.current;
    !m || !e.scrub || !m.moved && Math.abs(d.clientX - m.x) < 4 || (m.moved || e.scrub.begin(), m.moved = !0, e.scrub.on((d.clientX - m.last) * (e.step ?? 1) * (d.shiftKey ? 0.1 : d.altKey ? 10 : 1)), m.last = d.clientX);
  }, c = (d) => {
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
        onPointerMove: u,
        onPointerUp: c,
        onPointerCancel: c
      }
    ),
    n.value && l("span", { class: "why", role: "alert", id: `${e.id ?? e.label}-why`.replace(/\s/g, "-"), children: n.value })
  ] });
}

// src/icon.tsx
function z({ name: e }) {
  return l("svg", { class: "sign", "aria-hidden": "true", width: "16", height: "16", children: l("use", { href: `icons.svg#${e}` }) });
}

// src/menu.tsx
function Nt({ id: e, label: t, title: n, children: o }) {
  let r = (a) => {
    let s = document.getElementById(e), p = a.getBoundingClientRect();
    s?.style.setProperty("left", `${Math.max(8, Math.min(p.left, innerWidth - 296))}px`), s?.style.setProperty("top", `${p.bottom + 4}px`);
  };
  return l(Y, { children: [
    l("button", { ...{ popovertarget: e }, title: n, "aria-label": n, "aria-haspopup": "true", onPointerDown: (a) => r(a.currentTarget), onFocus: (a) => r(a.currentTarget), children: t }),
    l("div", { id: e, popover: "auto", class: "menu", children: o })
  ] });
}
function Er({ id: e, label: t }) {
  let n = yn(e), o = xa(e);
  return l(
    "button",
    {
      class: "item",
      "aria-disabled": n !== null,
      title: n ?? void 0,
      onClick: (r) => {
        r.currentTarget.closest("[popover]")?.hidePopover(), B(e);
      },
      children: [
        l("span", { children: t ?? o?.label }),
        l("kbd", { children: o?.keys })
      ]
    }
  );
}

// src/bar.tsx
var $a = {
  clean: "nothing changed",
  saved: "saved",
  waiting: "saving…",
  failed: "not saved"
};
function La() {
  let e = at.value, t = rt.value.undo, n = rt.value.redo, o = it.value, r = e.metered;
  return l("header", { class: "bar", children: [
    l(Nt, { id: "page-menu", label: l(z, { name: "menu" }), title: "Page", children: l(Z, { part: "PageItems" }) }),
    l("h1", { title: o.file || te.value?.file, children: [
      te.value?.name ?? "Lampyris",
      l("i", { class: `dot ${o.state}`, role: "img", "aria-label": $a[o.state], title: `${$a[o.state]}${o.file ? `: ${o.file}` : ""}` })
    ] }),
    l("span", { class: "group", children: [
      l("button", { class: "icon", "aria-label": t ? `Undo: ${t}` : "Undo", title: t ? `Undo: ${t} (Ctrl+Z)` : "Nothing to undo", "aria-disabled": t === null, onClick: () => B("undo"), children: l(z, { name: "undo" }) }),
      l("button", { class: "icon", "aria-label": n ? `Redo: ${n}` : "Redo", title: n ? `Redo: ${n} (Ctrl+Shift+Z)` : "Nothing to redo", "aria-disabled": n === null, onClick: () => B("redo"), children: l(z, { name: "redo" }) })
    ] }),
    l(Nt, { id: "view-menu", label: l(Y, { children: [
      "View ",
      l(z, { name: "down" })
    ] }), title: "View", children: l(Z, { part: "ViewItems" }) }),
    l("span", { class: "group wide", children: [
      l("button", { "aria-pressed": !1, onClick: () => B("preset-plan"), title: "Plan (Shift+1)", children: "Plan" }),
      l("button", { onClick: () => B("inside"), title: "Inside (Shift+0)", children: "Inside" })
    ] }),
    l("span", { class: "gap" }),
    l(Nt, { id: "seeing-menu", label: l(Y, { children: [
      "Picture ",
      l(z, { name: "down" })
    ] }), title: "Picture: tone, white, figures", children: l(Z, { part: "SeeingItems" }) }),
    l("button", { "aria-pressed": e.false_color !== null, onClick: _r, title: "False colour (B)", children: "False colour" }),
    l("button", { "aria-pressed": de.value === "wipe", "aria-disabled": dn.value === null, onClick: () => B("wipe"), title: "Wipe between before and now (C); hold \\ to see before", children: "Compare" }),
    l("span", { class: "group exposure", role: "group", "aria-label": "Exposure", children: [
      l("button", { class: "icon", "aria-label": "Darker", title: "Darker by ⅓ (,)", onClick: () => fo(1), children: l(z, { name: "minus" }) }),
      l("label", { children: [
        l("span", { "aria-hidden": "true", children: "EV" }),
        l(wn, { label: "Exposure value", quantity: "ev", value: e.ev ?? 0, step: 1 / 3, set: (i) => It({ ev: i(e.ev ?? 0) }) })
      ] }),
      l("button", { class: "icon", "aria-label": "Brighter", title: "Brighter by ⅓ (.)", onClick: () => fo(-1), children: l(z, { name: "plus" }) }),
      l("button", { class: "icon", "aria-label": "Meter once", title: `${r ? "As metered" : "Meter once"} (/); it stays locked`, onClick: () => K({ do: "expose" }), children: l(z, { name: r ? "lock" : "meter" }) })
    ] }),
    l(
      "button",
      {
        class: "icon look-lock",
        "aria-pressed": we.value,
        "aria-label": "Look-only lock",
        title: "Look-only lock: no finger changes anything",
        onClick: () => we.value = !we.value,
        children: l(z, { name: we.value ? "lock" : "unlock" })
      }
    ),
    pe.value === "edit" && l("button", { class: "wide", onClick: () => ft.value = "share", children: "Share" }),
    l("button", { class: "icon", "aria-label": "All keys", title: "All keys (?)", onClick: () => ft.value = "help", children: l(z, { name: "help" }) }),
    l("button", { class: "icon", "aria-label": "Command palette", title: "Command palette (Ctrl+K)", onClick: () => ft.value = "palette", children: l(z, { name: "search" }) }),
    l(
      "button",
      {
        class: "icon narrow",
        "aria-label": Ie.value === "inspector" ? "Lamps" : "Inspector",
        title: Ie.value === "inspector" ? "Lamps" : "Inspector",
        onClick: () => Ie.value = Ie.value === "inspector" ? "lamps" : "inspector",
        children: l(z, { name: Ie.value === "inspector" ? "lamps" : "sliders" })
      }
    )
  ] });
}

// src/highlight.ts
function mo(e) {
  _e.value = e, K({ do: "solo", lamps: e });
}
function Tr(e) {
  let t = _e.peek(), n = e.every((o) => t.includes(o));
  mo(n ? t.filter((o) => !e.includes(o)) : [...t, ...e.filter((o) => !t.includes(o))]);
}
var Sl = () => Tr(le.peek()), Pr = () => mo([]), kn = null;
function ho(e) {
  e && kn === null && le.peek().length ? (kn = _e.peek(), mo(le.peek())) : !e && kn !== null && (mo(kn), kn = null);
}

// src/lights.ts
var xn = g(null), vo = (e, t, n) => {
  xn.value = { x: e, y: t, hit: n, lux: n.lux, lamps: [], done: !1 };
}, $r = () => {
  xn.value = null;
};

// src/keys.ts
var Da = g("W A S D"), Lr = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyA: [0, -1, 0],
  KeyD: [0, 1, 0],
  KeyQ: [0, 0, -1],
  KeyE: [0, 0, 1]
}, Ml = 1.8, qt = /* @__PURE__ */ new Set(), go = !1, bo = 1, Vr = !1, Ir = 0;
function Fa(e) {
  let t = Math.min(0.1, Math.max(0, (e - Ir) / 1e3));
  if (Ir = e, !qt.size) {
    Vr = !1;
    return;
  }
  let [n, o, r] = [0, 0, 0];
  for (let s of qt) {
    let [p, u, c] = Lr[s];
    n += p, o += u, r += c;
  }
  let i = Math.max(1, He(...At()) / 12), a = Ml * t * bo * Math.min(i, 6);
  (n || o || r) && ya(n * a, o * a, r * a), requestAnimationFrame(Fa);
}
function Sn(e) {
  qt.add(e), !Vr && (Vr = !0, Ir = performance.now(), requestAnimationFrame(Fa));
}
var Va = (e) => e instanceof HTMLElement && (e.isContentEditable || e.matches("input, textarea, select") && !e.matches("[type=range], [type=checkbox], [type=radio]"));
function Ia() {
  let e = document.activeElement;
  return e === null || e === document.body || e.id === "view";
}
var Cl = {
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
}, Ra = {
  b: "quantity",
  o: "park",
  i: "unsolo",
  l: "from-lamp",
  g: "grid",
  t: "aim-here",
  n: "place"
}, Aa = { Comma: "darker", Period: "brighter", Slash: "expose" }, Ha = {
  Digit1: "preset-plan",
  Digit2: "preset-ceiling",
  Digit3: "preset-north",
  Digit4: "preset-east",
  Digit5: "preset-south",
  Digit6: "preset-west",
  Digit0: "inside"
};
function El(e) {
  let t = e.key.toLowerCase();
  return t === "z" ? e.shiftKey ? "redo" : "undo" : t === "y" ? "redo" : t === "k" ? "palette" : t === "s" ? e.shiftKey ? "picture" : "save" : t === "d" ? "duplicate" : t === "g" ? e.shiftKey ? "ungroup" : "group" : t === "a" ? "all-lamps" : t === "enter" ? "look-store" : null;
}
function Tl() {
  X.peek() ? X.value = null : xn.peek() ? $r() : de.peek() ? de.value = null : E.peek() ? ro() : document.activeElement?.id === "view" && document.querySelector('.bar button, .bar [tabindex="0"]')?.focus();
}
function Ka(e) {
  let [t, n] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
  return !t && !n ? !1 : (e.ctrlKey || oe()?.height ? Dt(-t * 24, n * 24, 3) : e.shiftKey ? so(Ot(), -t * 0.05, n * 0.05) : ao(-t * 0.06, n * 0.06), !0);
}
function Oa(e) {
  let t = oe(), n = ct();
  !t || !n || (t.height ? J(Bn(t, n, n.width / 2, n.height / 2, e)) : J(Wn(t, t.target, e, 0.3, !0)));
}
var Na = () => !1, Pl = (e) => {
  Na = e;
};
function $l(e) {
  if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
  if (!Va(e.target) && Na(e)) return e.preventDefault();
  let t = e.ctrlKey || e.metaKey;
  if (e.key === "Escape") return Tl();
  if (Va(e.target)) {
    t && e.key.toLowerCase() === "k" && Fe(e, "palette");
    return;
  }
  if (t && !e.altKey) {
    if (Ia() && Ka(e)) return e.preventDefault();
    let i = El(e);
    i && Fe(e, i);
    return;
  }
  if (e.altKey) {
    let i = /^Digit(\d)$/.exec(e.code)?.[1];
    if (e.key === "ArrowLeft") return Fe(e, "back");
    if (e.key === "ArrowRight") return Fe(e, "forth");
    if (i === "0") return Fe(e, "store-view");
    if (i) {
      e.preventDefault();
      let a = xt.all()[Number(i) - 1];
      a && J(a[1], a[1].name ?? "view");
      return;
    }
    if (e.code === "KeyH" && Fe(e, "unhide"), !(e.code in Lr)) return;
  }
  let n = Ia();
  if (n && Ka(e)) return e.preventDefault();
  if (n && e.code in Lr)
    return bo = e.shiftKey ? 4 : e.altKey ? 0.25 : 1, Sn(e.code), e.preventDefault();
  if (n && (e.key === "+" || e.key === "=")) return Oa(0.85);
  if (n && (e.key === "-" || e.key === "_")) return Oa(1 / 0.85);
  if (!or.peek()) return;
  if (e.shiftKey && Ha[e.code]) return Fe(e, Ha[e.code]);
  if (go && /^\d$/.test(e.key)) {
    e.preventDefault(), go = !1;
    let i = St.ids.peek()[Number(e.key) - 1];
    i !== void 0 && co({ do: "look", id: i, what: "recall", seconds: ir.peek() });
    return;
  }
  if (go = e.key.toLowerCase() === "j", go) return se("Recall a look: now its digit.");
  if (!e.shiftKey && /^\d$/.test(e.key) && le.peek().length) {
    e.preventDefault(), br.value = e.key;
    return;
  }
  if (!e.shiftKey && e.key !== "?" && Aa[e.code]) return Fe(e, Aa[e.code]);
  if (e.key === "\\") return void (e.repeat || mn(!0));
  let o = e.key.toLowerCase();
  if (o === "l" && !e.shiftKey) return void (e.repeat || B("highlight"));
  if (o === "p" && e.shiftKey) return Ll();
  let r = e.shiftKey && Ra[o] ? Ra[o] : Cl[o];
  r && !(e.target instanceof HTMLButtonElement && o === "enter") && Fe(e, r);
}
function Ll() {
  let [e, t] = ke.peek(), n = Kt(e / 2, t / 2);
  n && De("point", n, (o) => o.hit && vo(e / 2, t / 2, o));
}
function Fe(e, t) {
  e.preventDefault(), B(t);
}
function Vl(e) {
  qt.delete(e.code), e.key === "\\" && mn(!1), e.key.toLowerCase() === "l" && ho(!1), e.key === "Shift" && (bo = 1);
}
function qa() {
  addEventListener("keydown", $l), addEventListener("keyup", Vl), addEventListener("blur", () => {
    qt.clear(), ho(!1), mn(!1);
  }), navigator.keyboard?.getLayoutMap().then((t) => {
    Da.value = ["KeyW", "KeyA", "KeyS", "KeyD"].map((n) => (t.get(n) ?? n.slice(3)).toUpperCase()).join(" ");
  }).catch(() => {
  });
}
function Il(e, t) {
  for (let n of ["KeyW", "KeyS", "KeyA", "KeyD"]) qt.delete(n);
  bo = Math.min(1, Math.hypot(e, t)), e > 0.2 && Sn("KeyW"), e < -0.2 && Sn("KeyS"), t < -0.2 && Sn("KeyA"), t > 0.2 && Sn("KeyD");
}

// src/levels.ts
var Rr = (e) => Math.min(1, no.value === "square" ? Math.sqrt(Math.max(e, 0)) : e), Ar = (e) => {
  let t = no.peek() === "square" ? e * e : e;
  return Math.round(t * 1e3) / 1e3;
}, Rl = (e) => (e.kind === "lamp" ? k.get(e.id) : D.get(e.id))?.level ?? 0, yo = (e) => (e.kind === "lamp" ? k.get(e.id) : D.get(e.id))?.name ?? "";
function Hr(e) {
  let t = le.peek();
  return e.kind === "lamp" && E.peek()?.kind === "lamp" && t.length > 1 && t.includes(e.id) ? t : [e.id];
}
function Ua(e, t, n) {
  if (e.kind === "group") return { groups: { [e.id]: { level: t } } };
  let o = n.get(e.id) ?? 0, r = {};
  for (let [i, a] of n) {
    let s = i === e.id ? t : o > 0 ? Math.min(10, a * (t / o)) : t;
    r[i] = { level: Math.round(s * 1e3) / 1e3 };
  }
  return { lamps: r };
}
var Mn = class {
  constructor(t) {
    this.strip = t;
    this.was = this.now = Rl(t), this.from = t.kind === "lamp" ? new Map(Hr(t).map((n) => [n, k.get(n)?.level ?? 0])) : /* @__PURE__ */ new Map(), this.gesture = new Be(`${yo(t)} level`);
  }
  strip;
  gesture;
  from;
  was;
  now;
  to(t) {
    this.now = t, this.gesture.set(Ua(this.strip, t, this.from));
  }
  end() {
    let t = this.from.size > 1 ? io([...this.from.keys()]) : yo(this.strip);
    this.gesture.end(`${t} ${Re(this.was)} → ${Re(this.now)} %`);
  }
  cancel() {
    this.gesture.cancel();
  }
};
function _o(e, t) {
  let n = new Map(Hr(e).map((o) => [o, k.get(o)?.level ?? 0]));
  sr(`level ${e.kind} ${e.id}`, `${yo(e)} level`, Ua(e, t, n));
}
function Kr(e, t) {
  if (!e.length) return;
  let n = Object.fromEntries(e.map((r) => {
    let i = k.get(r);
    return [r, { level: t(i?.level ?? 0, i?.flux ?? 1) }];
  })), o = e.length === 1 ? ` ${Re(k.get(e[0])?.level ?? 0)} → ${Re(n[e[0]].level)} %` : " level";
  Le(`${io(e)}${o}`, { lamps: n });
}
function Or(e, t) {
  let n = t(D.get(e)?.level ?? 0);
  Le(`${D.get(e)?.name ?? "Group"} ${Re(n)} %`, { groups: { [e]: { level: n } } });
}
function Dr(e, t) {
  let n = `${yo(e)} ${t ? "on" : "off"}`;
  e.kind === "group" ? Le(n, { groups: { [e.id]: { on: t } } }) : Le(n, { lamps: Object.fromEntries(Hr(e).map((o) => [o, { on: t }])) });
}

// src/row.tsx
function Fr(e) {
  let t = e.color;
  return t.mode === "kelvin" ? `${G(t.kelvin)} K` : t.mode === "rgb" ? "RGB" : t.mode === "xy" ? "x y" : "file";
}
var wo = (e) => e.free ? "re-mix: level and colour cost no ray" : "re-trace: its light is traced anew";
function Nr(e, t, n) {
  let { kind: o, id: r } = e, i = o === "lamp" ? k.get(r) : void 0, a = o === "group" ? D.get(r) : void 0, s = i ?? a;
  if (!s) return null;
  let p = a?.lamps ?? [r], u = E.value?.kind === o && E.value.ids.includes(r), c = _e.value.length > 0 && !p.some((m) => _e.value.includes(m)), d = me.value?.kind === o && me.value.id === r;
  return {
    row: e,
    lamp: i,
    group: a,
    entry: s,
    members: p,
    selected: u,
    flux: p.reduce((m, f) => m + (k.get(f)?.flux ?? 0) * (a ? k.get(f)?.level ?? 0 : 1), 0),
    lumens: Go(p),
    stop: u ? 0 : -1,
    frame: {
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${o}-${r}`,
      onPointerEnter: () => me.value = { kind: o, id: r },
      onPointerLeave: () => me.value = null
    },
    state: `depth-${e.depth} ${o} ${u ? "selected" : ""} ${s.on && !i?.parked ? "" : "off"} ${c ? "muted" : ""} ${d ? "under" : ""}`
  };
}
function qr({ of: { row: e, entry: t, stop: n } }) {
  let o = Ge.value;
  return l("button", { class: "icon power", tabIndex: n, "aria-pressed": t.on, disabled: o !== null, "aria-label": `${t.name} on`, title: o ?? (t.on ? "On (O)" : "Off (O)"), onClick: () => Dr(e, !t.on), children: l(z, { name: "power" }) });
}
function Ur({ of: { row: e, entry: t, lamp: n, flux: o, selected: r }, label: i, tabIndex: a }) {
  let s = () => r && le.peek().length > 1 ? le.peek() : [e.id];
  return l(
    wn,
    {
      label: `${t.name} ${i}`,
      quantity: "level",
      value: t.level,
      flux: o,
      step: 0.01,
      disabled: Ge.value !== null,
      why: Ge.value,
      tabIndex: a,
      set: (p) => n ? Kr(s(), p) : Or(e.id, p)
    }
  );
}

// src/swatch.ts
var Al = (e) => e <= 31308e-7 ? 12.92 * e : 1.055 * e ** 0.4166666666666667 - 0.055, Hl = (e) => e <= 0.04045 ? e / 12.92 : ((e + 0.055) / 1.055) ** 2.4, Kl = (e) => Math.round(255 * Al(Math.max(0, Math.min(1, e))));
function jr(e) {
  let t = Math.max(...e, 1e-6);
  return ja(e.map((n) => n / t));
}
function ja(e) {
  return `#${e.map((t) => Kl(t).toString(16).padStart(2, "0")).join("")}`;
}
function Ol(e) {
  let t = (n) => Hl(parseInt(e.slice(1 + 2 * n, 3 + 2 * n), 16) / 255);
  return [t(0), t(1), t(2)];
}
var Dl = (e) => 1e6 / e;

// src/range.tsx
var Wa = -1e9;
addEventListener("scroll", () => Wa = performance.now(), { capture: !0, passive: !0 });
var Ut = (e) => Math.max(0, Math.min(1, e));
function Wr(e) {
  let t = ne(null), n = ne(null), o = e.notch ?? 0.01, r = (u) => {
    if (u.button !== 0 || e.disabled) return;
    let c = u.currentTarget.getBoundingClientRect(), d = e.vertical ? (c.bottom - u.clientY - 8) / (c.height - 16) : (u.clientX - c.left - 6) / (c.width - 12), m = u.pointerType !== "touch" && !u.shiftKey;
    n.current = { id: u.pointerId, x: u.clientX, y: u.clientY, at: m ? Ut(d) : e.value }, t.current?.setPointerCapture(u.pointerId), t.current?.focus(), e.begin?.(), m && e.on(Ut(d));
  }, i = (u) => {
    let c = n.current;
    if (!c || c.id !== u.pointerId) return;
    let d = u.currentTarget.getBoundingClientRect(), m = e.vertical ? (c.y - u.clientY) / (d.height - 16) : (u.clientX - c.x) / (d.width - 12);
    c.x = u.clientX, c.y = u.clientY, c.at += m * (u.shiftKey ? 0.1 : 1), e.on(Ut(c.at));
  }, a = (u) => {
    n.current?.id === u.pointerId && (n.current = null, u.type === "pointercancel" ? e.cancel?.() : e.end?.());
  }, s = (u) => {
    if (u.key === "Escape" && n.current) {
      n.current = null, e.cancel?.(), u.stopPropagation();
      return;
    }
    let c = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[u.key], d = null;
    c && (d = Ut(e.value + c * o * (u.shiftKey ? 10 : 1))), u.key === "Home" && (d = 0), u.key === "End" && (d = 1), !(d === null || u.altKey || u.ctrlKey || u.metaKey) && (u.preventDefault(), u.stopPropagation(), e.on(d));
  }, p = (u) => {
    if (performance.now() - Wa < 400 || u.ctrlKey) return;
    u.preventDefault();
    let c = Math.abs(u.deltaY) >= Math.abs(u.deltaX) ? u.deltaY : u.deltaX;
    c && e.on(Ut(e.value - Math.sign(c) * o * (u.shiftKey ? 0.2 : 1)));
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
      onMouseDown: (u) => u.preventDefault(),
      onTouchStart: (u) => u.cancelable && u.preventDefault(),
      onKeyDown: s,
      onWheel: p,
      onDblClick: () => e.reset?.(),
      onInput: (u) => {
        n.current ? u.currentTarget.value = String(e.value) : e.on(Number(u.currentTarget.value));
      }
    }
  );
}

// src/faderrow.tsx
function Ba({ row: e, index: t, count: n }) {
  let o = ne(null), r = Nr(e, t, n);
  if (!r) return null;
  let { lamp: i, group: a, entry: s, members: p, lumens: u } = r, c = p.length > 0 && p.every((m) => _e.value.includes(m)), d = (m) => () => {
    o.current?.[m](), o.current = null;
  };
  return l("div", { class: `fader-row ${r.state}`, ...r.frame, children: [
    l(qr, { of: r }),
    l("div", { class: "top", children: [
      a && l("button", { class: "icon fold", "aria-expanded": !dt.value.has(e.id), "aria-label": `Members of ${s.name}`, onClick: () => Ga(e.id), children: l(z, { name: dt.value.has(e.id) ? "right" : "down" }) }),
      l("button", { class: "row-name", "aria-pressed": r.selected, title: i ? `${i.name}: ${wo(i)}` : s.name, onClick: (m) => Br(m, e.kind, e.id), children: [
        l("span", { children: s.name }),
        a && l("small", { children: p.length }),
        i?.parked && l("small", { children: "parked" }),
        i && !i.free && l("small", { class: "traced", title: wo(i), children: [
          "↻",
          l("span", { class: "spoken", children: "re-trace" })
        ] })
      ] }),
      i && l("span", { class: "tint", children: [
        l("i", { class: "swatch", style: { background: jr(i.swatch) } }),
        Fr(i)
      ] }),
      l("button", { class: "icon solo", tabIndex: r.stop, "aria-pressed": c, "aria-label": `Solo ${s.name}`, title: "Solo (I)", onClick: () => Tr(p), children: l(z, { name: "solo" }) })
    ] }),
    l("div", { class: "bottom", children: [
      l(
        Wr,
        {
          label: `${s.name} level`,
          class: "level",
          value: Rr(s.level),
          text: `${Re(s.level)} %, ${Ye(u)} lumen`,
          notch: 0.01,
          disabled: Ge.value !== null,
          on: (m) => {
            let f = Ar(m);
            o.current ? o.current.to(f) : _o(e, f);
          },
          reset: () => _o(e, 1),
          begin: () => o.current = new Mn(e),
          end: d("end"),
          cancel: d("cancel")
        }
      ),
      l(Ur, { of: r, label: "level, typed", tabIndex: r.stop }),
      l("span", { class: "lumens", children: _n(u, "flux") })
    ] })
  ] });
}

// src/virtual.tsx
var za = 4;
function Gr({ count: e, height: t, row: n, label: o, show: r, role: i = "list" }) {
  let a = ne(null), s = nt(0), p = nt(600);
  Ce(() => {
    let d = a.current, m = new ResizeObserver(() => p.value = d.clientHeight);
    return m.observe(d), () => m.disconnect();
  }, []), Ce(() => {
    let d = a.current;
    if (!d || r === void 0 || r < 0) return;
    let m = r * t;
    (m < d.scrollTop || m + t > d.scrollTop + d.clientHeight) && (d.scrollTop = Math.max(0, m - d.clientHeight / 2));
  }, [r, t]);
  let u = Math.max(0, Math.floor(s.value / t) - za), c = Math.min(e, Math.ceil((s.value + p.value) / t) + za);
  return l("div", { class: "virtual", ref: a, tabIndex: e ? void 0 : -1, onScroll: (d) => s.value = d.currentTarget.scrollTop, children: l("div", { class: "all", role: i, "aria-label": o, style: { height: `${e * t}px` }, children: l("div", { class: "rows", role: "presentation", style: { transform: `translateY(${u * t}px)` }, children: Array.from({ length: Math.max(0, c - u) }, (d, m) => n(u + m)) }) }) });
}

// src/lamps.tsx
var ko = g(""), dt = g(/* @__PURE__ */ new Set()), xo = g("group"), Ya = N(() => {
  let e = ko.value.trim().toLowerCase(), t = k.listed(), n = D.listed(), o = new Map(n.map(([s, p]) => [s, p.name])), r = new Map(t.filter(([, s]) => !e || `${s.name} ${s.kind} ${o.get(s.group ?? -1) ?? ""}`.toLowerCase().includes(e)));
  if (xo.value !== "group" && $t.value === "sheet") {
    let s = xo.value, p = [...r];
    return p.sort(([, u], [, c]) => s === "name" ? u.name.localeCompare(c.name, "en", { numeric: !0 }) : c[s] - u[s]), p.map(([u]) => ({ kind: "lamp", id: u, depth: 0 }));
  }
  let i = [], a = /* @__PURE__ */ new Set();
  for (let [s, p] of n) {
    p.lamps.forEach((c) => a.add(c));
    let u = p.lamps.filter((c) => r.has(c));
    if (u.length) {
      if (p.lamps.length === 1) {
        i.push({ kind: "lamp", id: u[0], depth: 0 });
        continue;
      }
      i.push({ kind: "group", id: s, depth: 0 }), (!dt.value.has(s) || e) && u.forEach((c) => i.push({ kind: "lamp", id: c, depth: 1 }));
    }
  }
  for (let [s] of r) a.has(s) || i.push({ kind: "lamp", id: s, depth: 0 });
  return i;
}), Xa = !1;
D.ids.subscribe((e) => {
  Xa || !e.length || (Xa = !0, k.ids.peek().length > 40 && (dt.value = new Set(e.filter((t) => (D.get(t)?.lamps.length ?? 0) > 1))));
});
function Ga(e) {
  let t = new Set(dt.peek());
  t.delete(e) || t.add(e), dt.value = t;
}
function Br(e, t, n) {
  e.shiftKey ? pa(t, Ya.peek().filter((o) => o.kind === t).map((o) => o.id), n) : ze(t, n, e.ctrlKey || e.metaKey ? "toggle" : "only");
}
function Fl(e) {
  let t = { ArrowDown: 1, ArrowUp: -1 }[e.key], n = e.target;
  if (!t || !n.matches(".row-name")) return;
  e.preventDefault();
  let o = [...e.currentTarget.querySelectorAll(".row-name")];
  o[o.indexOf(n) + t]?.focus();
}
var Nl = ["add-spot", "add-point", "add-disc", "add-sphere"];
function Qa() {
  let e = Ya.value, t = E.value?.ids[E.value.ids.length - 1], n = e.findIndex((i) => i.kind === E.value?.kind && i.id === t), o = matchMedia("(pointer: coarse)").matches, r = $t.value === "sheet";
  return l("section", { class: "panel lamps", "aria-label": "Lamps", onKeyDown: Fl, children: [
    l("header", { class: "panel-head", children: [
      l("h2", { children: [
        "Lamps ",
        l("small", { children: G(k.ids.value.length) })
      ] }),
      l("span", { class: "gap" }),
      l("div", { class: "segments", role: "group", "aria-label": "Listing", children: [
        l("button", { "aria-pressed": !r, onClick: () => $t.value = "faders", children: "Faders" }),
        l("button", { "aria-pressed": r, onClick: () => $t.value = "sheet", children: "Sheet" })
      ] })
    ] }),
    l("div", { class: "panel-tools", children: [
      l("span", { class: "field filter", children: l(
        "input",
        {
          type: "text",
          "aria-label": "Filter lamps",
          placeholder: "Filter",
          value: ko.value,
          onInput: (i) => ko.value = i.currentTarget.value,
          onKeyDown: (i) => {
            i.key === "Escape" && (ko.value = "", i.stopPropagation());
          }
        }
      ) }),
      r && l("select", { "aria-label": "Order", value: xo.value, onChange: (i) => xo.value = i.currentTarget.value, children: [
        l("option", { value: "group", children: "by group" }),
        l("option", { value: "name", children: "by name" }),
        l("option", { value: "flux", children: "by flux" }),
        l("option", { value: "level", children: "by level" })
      ] }),
      l(Nt, { id: "add-menu", label: "Add", title: "Add a lamp", children: [
        Nl.map((i) => l(Er, { id: i }, i)),
        l("button", { class: "item", "aria-disabled": "true", title: "Photometric files come with a later version", children: [
          l("span", { children: "IES or LDT file…" }),
          l("kbd", { children: "later" })
        ] })
      ] })
    ] }),
    r && l(Z, { part: "SheetHead" }),
    l(
      Gr,
      {
        label: "Lamps and groups",
        count: e.length,
        height: r ? o ? 44 : 28 : o ? 84 : 54,
        show: n,
        row: (i) => {
          let a = e[i], s = r ? xr("SheetRow") : Ba;
          return s && l(s, { row: a, index: i, count: e.length }, `${a.kind}${a.id}`);
        }
      }
    ),
    le.value.length > 1 && l("p", { class: "several", children: [
      le.value.length,
      " selected; a fader moves them in proportion",
      E.value?.kind === "lamp" && l("button", { onClick: () => B("group"), children: "Group" }),
      l("button", { onClick: () => B("none"), children: "None" })
    ] }),
    !e.length && k.ids.value.length > 0 && l("p", { class: "quiet empty", children: "No lamp is called so." })
  ] });
}

// src/states.ts
var En = g(null), Qe = g([]), Tn = g(null), Xr = g(null), zr = N(() => Te.value?.stage ?? "loading"), Ja = g(!1), Cn = 0;
L(() => {
  let e = Te.value?.fps ?? 0;
  zr.value === "moving" && e > 6 && Pt.value < 0.4 * e && Pt.value < 5 ? Cn || (Cn = performance.now()) : Cn = 0, Ja.value = Cn > 0 && performance.now() - Cn > 2e3;
});
var jt = N(() => {
  switch (j.value) {
    case "entering":
      return "starting";
    case "open":
      break;
    default:
      return j.value;
  }
  return !te.value || !W.value ? "loading" : it.value.state === "failed" ? "unsaved" : En.value !== null ? "broken" : Tn.value !== null && !F.value.you ? "control-lost" : pe.value === "watch" || !F.value.you ? "watching" : k.ids.value.length === 0 ? "no-lamps" : Qi.value ? "all-off" : Ja.value ? "slow" : zr.value === "loading" ? "first" : zr.value;
});
Se("event", (e) => {
  switch (e.what) {
    case "reloaded": {
      En.value = null, Qe.value = e.lost ?? [];
      let t = e.kept ?? 0;
      se(`The scene was read again: ${t} edits kept${Qe.value.length ? `, ${Qe.value.length} no longer find what they changed` : ""}.`);
      break;
    }
    case "broken":
      En.value = e.why ?? "The scene file cannot be read.";
      break;
    case "taken":
      Tn.value = e.by ?? F.peek().name ?? "somebody else";
      break;
    case "loading":
      Xr.value = e;
      break;
  }
});
Se("refused", (e) => se(e.why ?? "That could not be done.", "warn"));
L(() => {
  F.value.you && (Tn.value = null);
});

// src/probe.ts
var So = g(null);
function Pn(e, t, n) {
  let o = Kt(e, t);
  if (!o) return n(null);
  De("point", o, (r) => n(r.hit ? r : null));
}
function Za(e) {
  if (!e) return "";
  let t = [], n = k.get(e.lamp)?.name, o = ye.get(e.thing)?.name, r = kt.get(e.material)?.name;
  if (n && t.push(n), o && o !== n && t.push(o), r && r !== o && t.push(r), e.lux && t.push(`${pt(e.lux[0])} ±${pt(e.lux[1], !1)}`), e.change != null && t.push(`Δ ${Mr(e.change * fn.peek())}`), e.luminance) {
    let i = e.luminance[0] * (Lt.value === "fc" ? 0.2919 : 1);
    t.push(`${Ye(i)} ${Lt.value === "fc" ? "fL" : "cd/m²"}`);
  }
  return t.join(" · ");
}

// src/status.tsx
var es = N(() => {
  W.value;
  let e = [];
  for (let t of ie.sent.slice(-24)) {
    if (t.what !== "set" && t.what !== "camera") continue;
    let n = ie.frames.find((o) => o.seq >= t.seq && o.painted);
    n && n.painted > t.at && e.push(n.painted - (t.input || t.at));
  }
  return e.sort((t, n) => t - n), e.length ? e[e.length >> 1] : null;
});
function ql() {
  let e = Te.value;
  if (!e) return "starting";
  let t = e.error == null ? "" : ` ±${G((e.error ?? 0) * 100, e.error < 0.0995 ? 1 : 0)} %`;
  switch (e.stage) {
    case "loading":
      return "first look";
    case "moving":
      return `moving${t}`;
    case "refining":
      return `${t.trim() || "refining"}${e.good_in ? `, good in ${G(e.good_in, e.good_in < 3 ? 1 : 0)} s` : ""}`;
    case "good":
      return `good${t}`;
    case "done":
      return `finished${t}`;
  }
}
function ts() {
  let e = Te.value, t = W.value?.head, n = an.value.filter((r) => r.batches < r.of && !r.held).length, o = e?.stage === "refining" && e.good_in ? Math.max(0.02, 1 / (1 + e.good_in)) : e?.stage === "good" || e?.stage === "done" ? 1 : 0.02;
  return l("footer", { class: "status", "aria-label": "Status", children: [
    l("span", { class: `quality ${e?.stage ?? ""}`, children: [
      l("i", { class: "thin", "aria-hidden": "true", children: l("b", { style: { width: `${o * 100}%` } }) }),
      ql()
    ] }),
    l("span", { children: [
      G(t?.batches ?? e?.batches ?? 0),
      " batches"
    ] }),
    l("span", { children: j.value === "open" ? `${G(Pt.value)} fps` : "no line" }),
    es.value !== null && l("span", { title: "From the hand to the paint, median", children: [
      G(es.value),
      " ms"
    ] }),
    t && l("span", { children: [
      t.width,
      " × ",
      t.height
    ] }),
    l("span", { class: "wide", children: [
      an.value.length,
      " layers",
      n ? `, ${n} tracing` : ""
    ] }),
    l("span", { class: "probe", "aria-live": "off", children: Za(So.value) }),
    l("span", { class: "gap" }),
    l("span", { children: F.value.you ? "editing: you" : `editing: ${F.value.name ?? "somebody else"}` }),
    l("span", { class: "spoken", children: [
      Qn.value ?? "",
      " ",
      jt.value
    ] })
  ] });
}

// src/pointer.ts
var Ul = 4, ns = 35e-4, jl = 0.15;
function Wl(e, t, n) {
  return e === "maya" && n.alt ? ["orbit", "pan", "dolly"][t] ?? "none" : e === "blender" && t === 1 ? n.shift ? "pan" : n.ctrl ? "dolly" : "orbit" : t === 1 ? n.shift ? "pan" : "orbit" : t === 2 ? "look" : t === 0 ? n.alt ? "orbit" : n.space ? "pan" : n.shift || n.ctrl ? "none" : "look" : "none";
}
function os(e, t) {
  let n = /* @__PURE__ */ new Map(), o = Ot(), r = 3, i = !1, a = 0, s = 0, p = 0, u = null, c = (h) => {
    let v = e.getBoundingClientRect();
    return [h.clientX - v.left, h.clientY - v.top];
  }, d = (h, v, T) => {
    let P = Kt(h, v);
    P && De("point", P, ($) => {
      let R = $;
      R.hit && T?.(R);
    });
  }, m = (h) => {
    let v = ct();
    return v ? Math.max(0.2, q(O(h, v.eye), v.forward)) : r;
  };
  function f(h) {
    if (h.target.closest("[data-handle]")) return;
    e.focus({ preventScroll: !0 });
    let [v, T] = c(h), P = h.pointerType === "touch", $ = { alt: h.altKey, shift: h.shiftKey, ctrl: h.ctrlKey || h.metaKey, space: i }, R = P ? "look" : Wl(to.peek(), h.button, $);
    R === "look" && oe()?.height && (R = "pan"), X.peek() === "marquee" && h.button === 0 && (R = "none"), n.set(h.pointerId, {
      id: h.pointerId,
      button: h.button,
      x: v,
      y: T,
      startX: v,
      startY: T,
      moved: !1,
      motion: R,
      touch: P,
      shift: h.shiftKey,
      ctrl: $.ctrl
    }), e.setPointerCapture(h.pointerId), clearTimeout(a), t.unhover(), (R === "orbit" || R === "pan" || R === "dolly") && (o = Ot(), r = m(o), d(v, T, (A) => {
      o = A.point, r = m(A.point);
    })), clearTimeout(s), P && n.size === 1 && (s = window.setTimeout(() => {
      let A = n.get(h.pointerId);
      A && !A.moved && n.size === 1 && (A.moved = !0, A.motion = "none", t.menu(A.x, A.y));
    }, 550)), n.size === 2 && (u = b()), h.button === 1 && h.preventDefault();
  }
  function b() {
    let [h, v] = [...n.values()];
    return { gap: Math.hypot(h.x - v.x, h.y - v.y), x: (h.x + v.x) / 2, y: (h.y + v.y) / 2 };
  }
  function y(h) {
    let v = n.get(h.pointerId), [T, P] = c(h);
    if (!v) {
      if (h.pointerType === "touch" || h.buttons) return;
      t.unhover(), clearTimeout(a), a = window.setTimeout(() => t.hover(T, P), 150);
      return;
    }
    let [$, R] = [T - v.x, P - v.y];
    if (!(!v.moved && Math.hypot(T - v.startX, P - v.startY) < Ul)) {
      if (v.moved = !0, v.x = T, v.y = P, n.size === 2 && u) {
        let A = b();
        Dt(A.x - u.x, A.y - u.y, r), A.gap > 8 && u.gap > 8 && w(A.x, A.y, u.gap / A.gap, !1), u = A;
        return;
      }
      if (X.peek() === "marquee" && v.button === 0) {
        t.marquee([v.startX, v.startY], [T, P], !1);
        return;
      }
      switch (v.motion) {
        case "look": {
          let A = v.touch ? 1 : -1;
          ao(A * $ * ns, A * R * ns);
          break;
        }
        case "orbit":
          so(o, -$ * 6e-3, -R * 6e-3);
          break;
        case "pan":
          Dt($, R, r);
          break;
        case "dolly":
          w(v.startX, v.startY, Math.exp(R * 6e-3), !1);
          break;
        case "none":
          break;
      }
    }
  }
  function x(h) {
    let v = n.get(h.pointerId);
    if (n.delete(h.pointerId), clearTimeout(s), n.size < 2 && (u = null), !(!v || h.type === "pointercancel")) {
      if (v.moved) {
        X.peek() === "marquee" && t.marquee([v.startX, v.startY], [v.x, v.y], !0);
        return;
      }
      if (v.touch) {
        let T = performance.now(), P = T - p < 320;
        if (p = T, P) return t.double(v.x, v.y);
        if (we.peek()) return;
      }
      if (v.button === 2) t.menu(v.x, v.y);
      else if (v.button === 0) {
        let T = v.shift ? "add" : v.ctrl ? "toggle" : "only";
        t.click(v.x, v.y, T);
      }
    }
  }
  let S = null;
  function w(h, v, T, P) {
    let $ = oe(), R = ct();
    if (!$ || !R) return;
    if ($.height) return J(Bn($, R, h, v, T));
    let A = performance.now();
    if (!S || A - S.time > 500 || Math.hypot(h - S.x, v - S.y) > 6) {
      S = { x: h, y: v, time: A, point: null };
      let ht = S;
      d(h, v, (ni) => {
        ht.point = ni.point, r = m(ni.point);
      });
    }
    S.time = A;
    let [ps, ds] = [h - R.width / 2, R.height / 2 - v], ms = Math.min(r, He($.eye, Ot()) + 1), Mo = (ht) => $.eye[ht] + (R.forward[ht] + R.side[ht] * ps * R.pixel + R.up[ht] * ds * R.pixel) * ms, ti = S.point ?? [Mo(0), Mo(1), Mo(2)];
    J(Wn($, ti, T, jl, P)), P && He($.eye, ti) < 0.5 && (S = null);
  }
  function M(h) {
    if (h.target.closest("[data-scroll]")) return;
    h.preventDefault();
    let v = h.deltaMode === 1 ? 18 : h.deltaMode === 2 ? 400 : 1, [T, P] = [h.deltaX * v, h.deltaY * v], [$, R] = c(h);
    if (to.peek() === "trackpad" && !h.ctrlKey) return Dt(-T, -P, r);
    let A = (h.ctrlKey ? 6 : 1) * (Math.abs(P) > Math.abs(T) ? P : T);
    w($, R, Math.exp(Math.max(-300, Math.min(300, A)) * 16e-4), h.shiftKey && !h.ctrlKey);
  }
  let I = (h) => h.preventDefault(), Me = () => {
    clearTimeout(a), t.unhover();
  }, Je = (h) => {
    !h.target.closest("[data-handle]") && X.peek() === null && t.double(...c(h));
  }, fe = (h) => {
    h.code === "Space" && (i = h.type === "keydown");
  }, ve = new ResizeObserver(() => {
    let h = e.getBoundingClientRect();
    ke.value = [Math.max(16, Math.round(h.width)), Math.max(16, Math.round(h.height))];
  });
  return ve.observe(e), e.addEventListener("pointerdown", f), e.addEventListener("pointermove", y), e.addEventListener("pointerup", x), e.addEventListener("pointercancel", x), e.addEventListener("pointerleave", Me), e.addEventListener("wheel", M, { passive: !1 }), e.addEventListener("contextmenu", I), e.addEventListener("dblclick", Je), addEventListener("keydown", fe), addEventListener("keyup", fe), () => {
    ve.disconnect(), removeEventListener("keydown", fe), removeEventListener("keyup", fe);
  };
}

// src/overlay.ts
var Bl = "http://www.w3.org/2000/svg";
function xe(e, t = {}, n) {
  let o = document.createElementNS(Bl, e);
  for (let [r, i] of Object.entries(t)) o.setAttribute(r, String(i));
  return n?.append(o), o;
}
var Qr = class {
  view;
  fit;
  constructor(t) {
    this.view = t, this.fit = gn(t.width, t.height);
  }
  at(t) {
    let [n, o, r] = en(this.view, t);
    return r < 0.02 && !this.view.parallel ? null : [this.fit.x + n * this.fit.scale, this.fit.y + o * this.fit.scale];
  }
  /** A line of the scene as a path, as much of it as lies before the eye. */
  line(t, n) {
    let [, , o] = en(this.view, t), [, , r] = en(this.view, n), i = 0.05, [a, s] = [t, n];
    if (!this.view.parallel) {
      if (o < i && r < i) return "";
      let c = (i - o) / (r - o), d = V(_(t, 1 - c), _(n, c));
      o < i && (a = d), r < i && (s = d);
    }
    let [p, u] = [this.at(a), this.at(s)];
    return !p || !u ? "" : `M${p[0].toFixed(1)} ${p[1].toFixed(1)}L${u[0].toFixed(1)} ${u[1].toFixed(1)}`;
  }
};
function Jr() {
  let e = W.value;
  return ke.value, e ? new Qr(_t(e.camera, e.head.width, e.head.height)) : null;
}
function rs() {
  let e = ue(Jr);
  return e ? k.all().flatMap(([t, n]) => {
    let o = is(n), r = o && e.at(o);
    return r ? [{ id: t, at: r }] : [];
  }) : null;
}
var is = gr, Gl = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
function Yr(e, t) {
  let n = yt(t);
  return Gl.map(([o, r]) => e.line(n[o], n[r])).join("");
}
var zl = 150, $n = class {
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
        let p = xe("g", { "data-kind": this.kind, "data-id": o }, this.parent);
        this.shape(p);
        let u = xe("text", { x: 10, y: 4 }, p);
        s = { group: p, label: u }, this.marks.set(o, s);
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
function as(e) {
  let t = xe("path", { class: "aims" }, e), n = xe("path", { class: "boxes" }, e), o = xe("path", { class: "boxes hover" }, e), r = xe("path", { class: "grid-lines" }, e), i = new $n(xe("g", {}, e), "lamp", (c) => xe("circle", { r: 4.5 }, c)), a = new $n(xe("g", {}, e), "grid", () => {
  }), s = new $n(xe("g", {}, e), "meter", (c) => {
    xe("circle", { r: 5.5 }, c), xe("path", { d: "M-9 0H9M0 -9V9" }, c);
  }), p = L(() => {
    let c = Jr();
    if (!c) return;
    let d = E.value, m = me.value, f = "", b = "", y = k.ids.value.length <= zl, x = k.all().map(([w, M]) => {
      let I = d?.kind === "lamp" ? d.ids.includes(w) : d?.kind === "group" && d.ids.includes(M.group ?? -1), Me = m?.kind === "lamp" ? m.id === w : m?.kind === "group" && m.id === M.group, Je = is(M), fe = M.place?.position;
      if (I && M.box && (b += Yr(c, M.box)), fe && M.place?.direction && (I || Me)) {
        let v = M.place.aim ?? V(fe, M.place.direction);
        f += c.line(fe, v);
      }
      let ve = I || Me || y && rr.value && (M.own || M.place?.position), h = `${I ? "selected" : ""} ${Me ? "under" : ""} ${sn(M) ? "" : "off"}`;
      return { id: w, at: Je && ve ? c.at(Je) : null, label: I || Me ? M.name : "", state: h };
    });
    if (i.draw(x), t.setAttribute("d", f), d?.kind === "thing")
      for (let w of d.ids) {
        let M = ye.get(w)?.box;
        M && (b += Yr(c, M));
      }
    n.setAttribute("d", b);
    let S = m?.kind === "lamp" ? k.get(m.id)?.box : m?.kind === "thing" ? ye.get(m.id)?.box : null;
    o.setAttribute("d", S ? Yr(c, S) : "");
  }), u = L(() => {
    let c = Jr();
    if (!c) return;
    let d = E.value, m = (b, y) => d?.kind === b && d.ids.includes(y) ? "selected" : "";
    s.draw(Mt.all().map(([b, y]) => ({
      id: b,
      at: c.at(y.point),
      label: y.lux ? pt(y.lux[0]) : "…",
      state: m("meter", b)
    })));
    let f = "";
    a.draw(zn.all().map(([b, y]) => {
      f += Xl(c, y);
      let x = y.mean == null ? "…" : `${y.name} ${pt(y.mean)}`;
      return { id: b, at: c.at(y.corner), label: x, state: m("grid", b) };
    })), r.setAttribute("d", f);
  });
  return () => {
    p(), u(), e.replaceChildren();
  };
}
function ss({ corner: e, u: t, v: n, columns: o, rows: r, border: i = 0 }, a, s) {
  let p = (u, c, d) => {
    let m = be(u) > 2 * i ? i / be(u) : 0;
    return _(u, m + (1 - 2 * m) * (c + 0.5) / d);
  };
  return V(e, V(p(t, a, o), p(n, s, r)));
}
function Xl(e, t) {
  let n = (r, i) => V(t.corner, V(_(t.u, r), _(t.v, i))), o = e.line(n(0, 0), n(1, 0)) + e.line(n(1, 0), n(1, 1)) + e.line(n(1, 1), n(0, 1)) + e.line(n(0, 1), n(0, 0));
  for (let r = 0; r < t.rows; r++)
    for (let i = 0; i < t.columns; i++) {
      let a = e.at(ss(t, i, r));
      a && (o += `M${(a[0] - 2).toFixed(1)} ${a[1].toFixed(1)}h4m-2 -2v4`);
    }
  return o;
}

// src/banner.tsx
function ce({ tone: e, children: t }) {
  return l("div", { class: `banner ${e}`, role: e === "warn" ? "alert" : "status", children: t });
}
var ls = () => `lampyris view ${te.peek()?.file ?? "SCENE"} --port ${location.port || 80}`;
function Yl() {
  let e = k.all().filter(([, n]) => !n.on || n.level === 0 || n.parked), t = D.all().filter(([, n]) => !n.on || n.level === 0);
  Le("All lamps on", {
    lamps: Object.fromEntries(e.map(([n, o]) => [n, { on: !0, parked: !1, ...o.level === 0 ? { level: 1 } : {} }])),
    groups: Object.fromEntries(t.map(([n, o]) => [n, { on: !0, ...o.level === 0 ? { level: 1 } : {} }]))
  });
}
function Ql() {
  switch (jt.value) {
    case "starting":
      return l(ce, { tone: "calm", children: "Entering…" });
    case "loading": {
      let e = Xr.value;
      return l(ce, { tone: "calm", children: [
        "Reading ",
        e?.file ?? te.value?.file ?? "the scene",
        "…",
        e?.bytes ? ` ${G(e.bytes / 1e6, 1)} MB` : "",
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
          l("code", { children: ls() }),
          ": this page comes back by itself."
        ] }),
        l("button", { onClick: () => {
          wr(ls());
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
        l("button", { onClick: () => ft.value = "save", children: "Save elsewhere" })
      ] });
    case "broken":
      return l(ce, { tone: "warn", children: [
        En.value,
        " Still showing what was read before."
      ] });
    case "control-lost":
      return l(ce, { tone: "warn", children: [
        l("span", { children: [
          "Control moved to ",
          l("em", { children: Tn.value }),
          "."
        ] }),
        " ",
        l("button", { onClick: () => K({ do: "edit", what: "take" }), children: "Take it back" })
      ] });
    case "watching":
      return l(ce, { tone: "calm", children: [
        l("span", { children: [
          "You are watching",
          F.value.name ? l(Y, { children: [
            "; ",
            l("em", { children: F.value.name }),
            " edits"
          ] }) : "",
          "."
        ] }),
        l("button", { onClick: () => K({ do: "edit", what: "take" }), children: "Ask for control" })
      ] });
    case "no-lamps":
      return l(ce, { tone: "calm", children: [
        "This scene has no light. Add:",
        l(
          "button",
          {
            onClick: () => {
              hr.value = "disc", vr("add");
            },
            children: "ceiling lamp"
          }
        ),
        l("button", { disabled: !0, title: "Photometric files come with a later version", children: "IES file" })
      ] });
    case "all-off":
      return l(ce, { tone: "warn", children: [
        "All lamps are off.",
        rt.value.undo && l("button", { onClick: () => B("undo"), children: "Undo" }),
        l("button", { onClick: Yl, children: "Turn on" })
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
function us() {
  let e = _e.value;
  return l("div", { class: "banners", "data-scroll": !0, children: [
    Ql(),
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
      e.length === 1 ? k.get(e[0])?.name ?? "one lamp" : `${e.length} lamps`,
      l("button", { onClick: Pr, children: "End solo" })
    ] }),
    l("div", { class: "notes", role: "status", "aria-live": "polite", children: ut.value.map((t) => l("div", { class: `banner ${t.tone === "warn" ? "warn" : "calm"}`, children: [
      t.text,
      l("button", { class: "icon", "aria-label": "Close", onClick: () => ar(t.id), children: l(z, { name: "close" }) })
    ] }, t.id)) })
  ] });
}

// src/view.tsx
var cs = g(null);
function Jl(e, t) {
  let n = rs();
  if (!n) return [];
  let [o, r] = [Math.min(e[0], t[0]), Math.max(e[0], t[0])], [i, a] = [Math.min(e[1], t[1]), Math.max(e[1], t[1])];
  return n.filter(({ at: s }) => s[0] >= o && s[0] <= r && s[1] >= i && s[1] <= a).map(({ id: s }) => s);
}
var Zl = {
  click(e, t, n) {
    let o = Zr(e, t);
    if (X.peek() === null && o) return ze(o.kind, o.id, n);
    Pn(e, t, (r) => {
      if (r && (hn.value = { point: r.point, normal: r.normal }), X.peek() !== null) return wa(r);
      ma(r, n), E.peek() && (Ie.value = "inspector");
    });
  },
  menu(e, t) {
    Pn(e, t, (n) => {
      n && vo(e, t, n);
    });
  },
  double(e, t) {
    if (Zr(e, t)) return B("frame");
    Pn(e, t, (n) => {
      n && (hn.value = { point: n.point, normal: n.normal }), B(n && !yn("there") ? "there" : "frame");
    });
  },
  hover(e, t) {
    let n = Zr(e, t);
    n?.kind === "lamp" && (me.value = { kind: "lamp", id: n.id }), Pn(e, t, (o) => {
      So.value = o, o && (hn.value = { point: o.point, normal: o.normal }), o?.lamp != null && (me.value = { kind: "lamp", id: o.lamp });
    });
  },
  unhover() {
    me.peek() && (me.value = null);
  },
  marquee(e, t, n) {
    if (cs.value = n ? null : { from: e, to: t }, !n) return;
    let o = Jl(e, t);
    E.value = o.length ? { kind: "lamp", ids: o } : null, X.value = null;
  }
};
function Zr(e, t) {
  let n = document.getElementById("overlay"), o = null, r = 11;
  for (let i of n?.querySelectorAll(".mark:not([display])") ?? []) {
    let a = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(i.getAttribute("transform") ?? "");
    if (!a) continue;
    let s = Math.hypot(Number(a[1]) - e, Number(a[2]) - t);
    s < r && (r = s, o = { kind: i.dataset.kind, id: Number(i.dataset.id) });
  }
  return o;
}
var eu = {
  aim: "Click what shall be lit. Esc to leave.",
  place: "Click the surface on which the lamp shall be. Esc to leave.",
  meter: "Click where the meter shall lie. Esc to leave.",
  grid: "Click two opposite corners of the area. Esc to leave.",
  add: "Click where the lamp shall hang. Esc to leave.",
  marquee: "Drag around the lamps to select. Esc to leave."
};
function fs() {
  let e = ne(null), t = ne(null), n = ne(null);
  return Ce(() => {
    Jo(t.current);
    let o = as(n.current), r = os(e.current, Zl);
    return () => {
      Jo(null), o(), r();
    };
  }, []), Ai(() => {
    let o = W.value;
    t.current?.setAttribute("data-kind", o?.head.kind ?? "none");
  }), l("main", { class: "view", "aria-label": "View", children: [
    l(
      "div",
      {
        class: X.value ? "stage tooled" : "stage",
        id: "view",
        ref: e,
        tabIndex: 0,
        role: "application",
        "aria-label": `View of ${te.value?.name ?? "the scene"}${Ht.value ? `, ${Ht.value}` : ""}`,
        "aria-describedby": "view-keys",
        "data-tool": X.value ?? "",
        children: [
          l("canvas", { ref: t, width: 640, height: 480, "aria-hidden": "true" }),
          l("svg", { id: "overlay", ref: n, "aria-hidden": "true" }),
          l(Z, { part: "Gizmo" }),
          l(Z, { part: "Compare" }),
          l(tu, {})
        ]
      }
    ),
    l("p", { id: "view-keys", class: "spoken", children: "Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection, Escape leaves the view." }),
    X.value && l("p", { class: "hint", role: "status", children: eu[X.value] }),
    l(us, {}),
    l(Z, { part: "TypedHint" }),
    l(Z, { part: "Legend" }),
    l(Z, { part: "CutBar" }),
    l(Z, { part: "ViewStrip" }),
    l(Z, { part: "WalkPad" }),
    l(Z, { part: "What" })
  ] });
}
function tu() {
  let e = cs.value;
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
function nu() {
  return l(Y, { children: [
    l(La, {}),
    l(Qa, {}),
    l(fs, {}),
    l("section", { class: "panel inspector", "aria-label": "Inspector", children: l(Z, { part: "Inspector" }) }),
    l("section", { class: "strip", "aria-label": "Looks and meters", children: l(Z, { part: "Strip" }) }),
    l(ts, {}),
    l(Z, { part: "Sheets" })
  ] });
}
var mt = document.getElementById("desk");
mt.replaceChildren();
hi(l(nu, {}), mt);
L(() => {
  mt.dataset.state = jt.value, mt.dataset.line = j.value, mt.dataset.pen = pe.value === "edit" && F.value.you && !we.value ? "yes" : "no";
});
L(() => {
  mt.dataset.panels = nr.value ? "yes" : "no", mt.dataset.drawer = Ie.value ?? "none";
});
L(() => {
  document.documentElement.dataset.theme = Zo.value, document.documentElement.style.setProperty("--house", String(er.value));
});
L(() => {
  te.value && (document.title = `${te.value.name} – Lampyris`);
});
var ei = 0;
L(() => {
  let [e, t] = ke.value, n = We.value ? Math.min(devicePixelRatio, 2) : 1;
  j.value !== "open" || pe.value === "watch" || !F.value.you || (clearTimeout(ei), ei = window.setTimeout(() => K({ do: "size", width: Math.round(e * n), height: Math.round(t * n) }), ei && 60));
});
Ca();
qa();
na();
export {
  yr as DEFAULT_FALSE,
  va as EYE_HEIGHT,
  Mn as Fade,
  wn as Field,
  Y as Fragment,
  Be as Gesture,
  z as Icon,
  Er as Item,
  Ur as LevelField,
  Ds as PRESETS,
  qr as Power,
  Wr as Range,
  Gr as Virtual,
  ot as across,
  B as act,
  V as add,
  hr as adding,
  _l as allActions,
  De as ask,
  ka as asked,
  il as back,
  dn as before,
  he as camera,
  Lt as candles,
  le as chosenLamps,
  Pr as clearSolo,
  $r as closeWhat,
  Fr as colorText,
  co as command,
  mn as compareHeld,
  de as comparing,
  qi as compass,
  N as computed,
  wr as copyText,
  wo as cost,
  ge as cross,
  jr as css,
  pl as cut,
  ro as deselect,
  G as digits,
  at as display,
  He as distance,
  q as dot,
  hl as each,
  Le as edit,
  F as editor,
  L as effect,
  fo as exposeBy,
  ir as fade,
  vl as falseColor,
  Fs as filterOf,
  We as fine,
  gn as fitted,
  _n as format,
  al as forth,
  ul as frameSelection,
  lo as free,
  Ol as fromHex,
  J as go,
  mr as goHome,
  fl as goInside,
  cl as goPreset,
  ss as gridPoint,
  zn as grids,
  D as groups,
  ol as handles,
  to as hands,
  Se as hear,
  oe as here,
  ja as hex,
  ho as highlight,
  rt as history,
  er as houseLights,
  me as hovered,
  l as jsx,
  l as jsxs,
  Pl as keysFirst,
  rr as lampMarks,
  k as lamps,
  an as layers,
  be as length,
  Nr as listed,
  $t as listing,
  we as lookOnly,
  St as looks,
  Go as lumensOf,
  Cr as luxText,
  pt as maintained,
  fn as maintenance,
  kt as materials,
  Mt as meters,
  Ue as middle,
  Dl as mired,
  Ke as moved,
  da as nameOf,
  ee as normal,
  ml as onTool,
  sn as output,
  Il as padWalk,
  nr as panels,
  Ge as penless,
  Re as percent,
  Br as pickRow,
  _t as pinhole,
  gr as positionOf,
  en as project,
  Os as ray,
  yl as register,
  pe as role,
  se as say,
  _ as scale,
  te as scene,
  ze as select,
  E as selection,
  K as send,
  dl as setCut,
  ft as sheet,
  It as show,
  W as shown,
  g as signal,
  Mr as signed,
  or as singleKeys,
  Sl as soloSelection,
  hn as spot,
  vr as startTool,
  Te as status,
  Zs as step,
  rl as stepSelection,
  bl as storeLook,
  gl as storeView,
  sr as stroke,
  _o as strokeLevel,
  O as sub,
  Dr as switchOn,
  Zo as theme,
  ye as things,
  Ye as three,
  io as titleOf,
  Ar as toLevel,
  Rr as toTravel,
  _r as toggleFalse,
  nl as toggleWipe,
  X as tool,
  no as travel,
  Zt as turn,
  Or as typeGroupLevel,
  Kr as typeLevel,
  ue as untracked,
  Ve as up,
  Ce as useEffect,
  Ss as useLayoutEffect,
  ne as useRef,
  Ht as viewName,
  ke as viewSize,
  xt as views,
  Da as walkNames,
  tr as walking,
  br as wantLevel,
  xn as what,
  oo as whyNot,
  yn as whyNotTo,
  el as wipeAt,
  Ys as workPlane
};
