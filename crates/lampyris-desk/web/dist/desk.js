// node_modules/preact/dist/preact.mjs
var C, zr, Io, We, Lo, Vn, Gr, Pn, Xr, Ao, Vo, as, Yt = /* @__PURE__ */ Symbol.for("pv"), In = {}, An = [], ss = /^m(i|n|o|s|text|space)$/, Ro = Array.isArray, Ho = An.slice, ot = Object.assign;
function nt(e) {
  e && e.parentNode && e.remove();
}
function Yr(e, t, n) {
  var o, r, i, a = {}, l = arguments.length;
  for (i in t) i == "key" ? o = t[i] : i == "ref" && typeof e != "function" ? r = t[i] : a[i] = t[i];
  return l > 2 && (a.children = l > 3 ? Ho.call(arguments, 2) : n), Xt(e, a, o, r, null);
}
function Xt(e, t, n, o, r) {
  var i = { type: e, props: t, key: n, ref: o, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: Yt, __v: r || ++zr, __i: -1, __u: 0 };
  return !r && C.vnode && C.vnode(i), i;
}
function X(e) {
  return e.children;
}
function wt(e, t) {
  this.props = e, this.context = t, this.__g = 0;
}
function Be(e, t) {
  if (t == null) return e.__ && Be(e.__, e.__i + 1);
  for (var n; t < e.__k.length; t++) if ((n = e.__k[t]) && n.__e) return n.__e;
  return typeof e.type != "function" || e.props.__P ? null : Be(e);
}
function ls(e) {
  var t, n = e.__v, o = n.__e, r = [], i = [], a = e.__P;
  a && ((t = ot({ constructor: Yt }, n)).__v = n.__v + 1, C.vnode && C.vnode(t), Oo(a, t, n, e.__n, a.namespaceURI, 32 & n.__u ? [o] : null, r, o || Be(n), 32 & n.__u, i), t.__v = n.__v, t.__.__k[t.__i] = t, ni(r, t, i), n.__ = n.__e = null, t.__e != o && Qr(t));
}
function Qr(e) {
  if ((e = e.__) && e.__c && !e.props.__P) return e.__e = null, e.__k.some(function(t) {
    return t && (e.__e = t.__e);
  }), Qr(e);
}
function Wr(e) {
  (8 & e.__g || (e.__g |= 8, We.push(e), Vn++)) && Lo == C.debounceRendering || ((Lo = C.debounceRendering) || queueMicrotask)(Jr);
}
function Jr() {
  try {
    for (var e, t = 1; We.length; ) We.length > t && We.sort(Gr), e = We.shift(), t = We.length, 8 & e.__g && ls(e);
  } finally {
    (Vn = We.length) && (Lo || queueMicrotask)(Jr);
  }
}
function Zr(e, t, n, o, r, i, a, l, d, u, c) {
  var p, m, f, _, k, S, y = o.__k || An, b = t.length;
  for (d = us(n, t, y, d, b), p = 0; p < b; p++) (f = n.__k[p]) != null && (m = ~f.__i && y[f.__i] || In, f.__i = p, S = Oo(e, f, m, r, i, a, l, d, u, c), _ = f.__e, (m.ref != f.ref || 8 & m.__u) && (m.ref && Ko(m.ref, null, f, m), f.ref && c.push(f.ref, f.__c || _, f)), k = k || _, 4 & f.__u ? (d = ei(f, d, e, !m.__v), m.__e && (m.__e = null)) : typeof f.type == "function" && S !== void 0 ? d = S : _ && (d = _.nextSibling), f.__u &= -21);
  return n.__e = k, d;
}
function us(e, t, n, o, r) {
  var i, a, l, d, u, c, p, m, f, _ = n.length, k = _, S = 0, y = 0, b = e.__k = Array(r);
  for (i = 0; i < r; i++) (a = t[i]) != null && typeof a != "boolean" && typeof a != "function" ? (typeof a != "object" || a.constructor === String ? a = b[i] = Xt(null, a) : Ro(a) ? a = b[i] = Xt(X, { children: a }) : a.constructor === Yt && a.__b ? a = b[i] = Xt(a.type, a.props, a.key, a.ref, a.__v) : b[i] = a, d = i + S, a.__ = e, a.__b = e.__b + 1, l = null, ~(u = a.__i = cs(a, n, d, k)) && (k--, (l = n[u]) && (l.__u |= 2)), l && l.__v ? (a.__u |= 16, u == d - 1 ? S-- : u == d + 1 ? S++ : u != d && (u > d ? S-- : S++, y = 1)) : (~u || (r > _ ? S-- : r < _ && S++), typeof a.type != "function" && (a.__u |= 4))) : b[i] = null;
  if (y) {
    for (c = [], p = [], i = 0; i < r; i++) if ((a = b[i]) && 16 & a.__u) {
      for (S = 0, m = c.length; S < m; ) c[f = S + m >> 1] < a.__i ? S = f + 1 : m = f;
      c[S] = a.__i, p[i] = S + 1;
    }
    for (S = c.length; i--; ) p[i] && (p[i] == S ? S-- : b[i].__u |= 4);
  }
  if (k) for (i = 0; i < _; i++) !(l = n[i]) || 2 & l.__u || (l.__e == o && (o = Be(l)), Do(l, l));
  return o;
}
function ei(e, t, n, o) {
  var r, i, a, l;
  if (typeof e.type == "function") {
    if (e.props.__P) return t;
    if (r = e.__k) for (i = 0; i < r.length; i++) r[i] && (r[i].__ = e, t = ei(r[i], t, n, !1));
    return t;
  }
  for (t && !t.parentNode && (t = Be(e)) && !t.parentNode && (t = null), a = e.__e, l = t; l && l.nodeType == 8; ) l = l.nextSibling;
  for (a != l && (!o && n.moveBefore && a.parentNode ? n.moveBefore(a, t) : n.insertBefore(a, t || null)), t = a; (t = t && t.nextSibling) && t.nodeType == 8 && !t.data.startsWith("$s"); ) ;
  return t;
}
function cs(e, t, n, o) {
  var r, i = e.key, a = e.type, l = t[n], d = l && !(2 & l.__u);
  if (l === null && i == null || d && i == l.key && a == l.type) return n;
  if (o > (d ? 1 : 0)) {
    for (r = n - 1; r >= 0; r--) if ((l = t[r]) && !(2 & l.__u) && i == l.key && a == l.type) return r;
    for (r = n + 1; r < t.length; r++) if ((l = t[r]) && !(2 & l.__u) && i == l.key && a == l.type) return r;
  }
  return -1;
}
function Br(e, t, n) {
  n == null && (n = ""), t[0] == "-" ? e.setProperty(t, n) : e[t] = n;
}
function $n(e, t, n, o, r) {
  var i, a;
  if (t == "style") if (typeof n == "string") e.style.cssText = n;
  else {
    if (typeof o == "string" && (e.style.cssText = o = ""), o) for (t in o) n && t in n || Br(e.style, t);
    if (n) for (t in n) o && n[t] == o[t] || Br(e.style, t, n[t]);
  }
  else if (t[0] == "o" && t[1] == "n") typeof n != "function" && (n = null), typeof o != "function" && (o = null), (e.__e || (e.__e = {}))[t] = n, n && o || (a = Vo[t] || (Vo[t] = fs(t)), (e.__a || (e.__a = {}))[t] = Ao, i = t != (t = t.replace(Xr, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), n ? e.addEventListener(t, a, i) : e.removeEventListener(t, a, i));
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
function fs(e) {
  return function(t) {
    var n = this.__e;
    if (n) {
      if (n = n[e], t[Pn] == null) t[Pn] = Ao++;
      else if (t[Pn] < this.__a[e]) return;
      return n(C.event ? C.event(t) : t);
    }
  };
}
function Oo(e, t, n, o, r, i, a, l, d, u) {
  var c, p, m, f, _, k, S, y, b, R, V, je, Ue, Se, ge, h, v, $, P = t.type;
  if (t.constructor !== Yt) return null;
  128 & n.__u && (d = 32 & n.__u, c = n.__c.__z) && (t.__u |= d, p = i = [], c.nodeType == 8 ? l = Ln(c, i) : i.push(c), l = i[0] || l), (c = C.__b) && c(t);
  e: if (typeof P == "function") {
    m = a.length;
    try {
      if (y = t.props, b = (c = P.prototype) && c.render, R = (c = P.contextType) && o[c.__c], V = c ? R ? R.props.value : c.__ : o, (f = n.__c) ? (t.__c = f, 2 & f.__g && (f.__g |= 1)) : (b ? t.__c = f = new P(y, V) : (t.__c = f = new wt(y, V), f.constructor = P, f.render = ds), R && R.sub(f), f.state || (f.state = {}), f.__n = o, f.__g |= 8, f.__h = [], f.__k = []), b && (f.__s || (f.__s = f.state), P.getDerivedStateFromProps && (f.__s == f.state && (f.__s = ot({}, f.__s)), ot(f.__s, P.getDerivedStateFromProps(y, f.__s)))), _ = f.props, k = f.state, f.__v = t, n.__c) {
        if (y !== _ && b && !P.getDerivedStateFromProps && f.componentWillReceiveProps && f.componentWillReceiveProps(y, V), t.__v == n.__v && !(8 & f.__g) || !(4 & f.__g) && f.shouldComponentUpdate && f.shouldComponentUpdate(y, f.__s, V) === !1) {
          t.__v != n.__v && (f.props = y, f.state = f.__s, f.__g &= -9), t.__e = n.__e, t.__k = n.__k, t.__k.some(function(L) {
            L && (L.__ = t);
          }), An.push.apply(f.__h, f.__k), f.__k = [], f.__h.length && a.push(f), l = Be(n);
          break e;
        }
        f.componentWillUpdate && f.componentWillUpdate(y, f.__s, V), b && f.componentDidUpdate && f.__h.push(function() {
          f.componentDidUpdate(_, k, S);
        });
      } else b && !P.getDerivedStateFromProps && f.componentWillMount && f.componentWillMount(), b && f.componentDidMount && f.__h.push(f.componentDidMount);
      f.context = V, f.props = y, f.__P = e, f.__g &= -5, je = C.__r, Ue = b ? 25 : 0;
      do
        f.__g &= -9, je && je(t), c = f.render(f.props, f.state = f.__s, f.context);
      while (8 & f.__g && ++Ue < 25);
      b && (An.push.apply(f.__h, f.__k), f.__k = []), f.state = f.__s, f.getChildContext && (o = ot({}, o, f.getChildContext())), b && n.__c && f.getSnapshotBeforeUpdate && (S = f.getSnapshotBeforeUpdate(_, k)), Se = c && c.type === X && c.key == null ? c.props.children : c, y.__P && (c = l, r = (e = y.__P).namespaceURI, d = i = null, n.props && n.props.__P != e && (n.__k.some(function(L) {
        L && Do(L, L);
      }), n.__k = null), l = n.__k ? Be(n, 0) : null), l = Zr(e, Ro(Se) ? Se : [Se], t, n, o, r, i, a, l, d, u), y.__P && (t.__e = null, l = c), t.__u &= -161, p && p.some(nt), f.__h.length && a.push(f), 1 & f.__g && (f.__g &= -4);
    } catch (L) {
      if (a.length = m, t.__v = null, d || i) if (L && L.then) {
        if (t.__u |= 128 | d, i) {
          for (~(v = i.indexOf(l || void 0)) || (v = i.length); ($ = i[v - 1]) && $.nodeType == 8; ) v--;
          for (; v < i.length; v++) if ($ = i[v]) if (i[v] = null, ge) {
            if ($ == h) break;
          } else {
            if ($.nodeType != 8) break;
            $.data.startsWith("$s") && (h = Ln(ge = $));
          }
        }
        if (!ge) {
          for (; l && l.nodeType == 8 && l.nextSibling; ) l = l.nextSibling;
          ge = l;
        }
        (c = Ln(ge = t.__c.__z || (t.__c.__z = ge))) ? (t.__e = ge, l = c) : t.__e = l, l = l && l.nextSibling;
      } else i && i.some(nt);
      else t.__e = n.__e;
      t.__k || (t.__k = n.__k || []), L && L.then || ti(t), C.__e(L, t, n);
    }
  } else l = t.__e = ps(n.__e, t, n, o, r, i, a, d, u, e);
  return (c = C.diffed) && c(t), l;
}
function Ln(e, t) {
  if (e && e.nodeType == 8 && e.data.startsWith("$s")) for (var n = 1; e = e.nextSibling; ) {
    if (e.nodeType == 8) {
      if (e.data.startsWith("$s")) n++;
      else if (e.data.startsWith("/$s") && !--n) return e;
    }
    t && t.push(e);
  }
}
function ti(e) {
  e && (e.__c && (e.__c.__g |= 4), e.__k && e.__k.some(ti));
}
function ni(e, t, n) {
  for (var o = 0; o < n.length; ) Ko(n[o++], n[o++], n[o++]);
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
function ps(e, t, n, o, r, i, a, l, d, u) {
  var c, p, m, f, _, k, S, y, b = n.props || In, R = t.props, V = t.type;
  if (V == "svg" ? r = "http://www.w3.org/2000/svg" : V == "math" ? r = "http://www.w3.org/1998/Math/MathML" : r || (r = "http://www.w3.org/1999/xhtml"), i) {
    for (c = 0; c < i.length; c++) if ((_ = i[c]) && (V ? _.localName == V : _.nodeType == 3)) {
      e = _, i[c] = null;
      break;
    }
  }
  if (!e) {
    if (y = u.ownerDocument || document, !V) return y.createTextNode(R);
    e = y.createElementNS(r, V, R.is ? R : u), l && (C.__m && C.__m(t, i), l = !1), i = null;
  }
  if (V) {
    if (u = V == "template" && e.content || e, i = V == "textarea" && R.defaultValue != null ? null : i && Ho.call(u.childNodes), !l && i) for (b = {}, c = 0; c < e.attributes.length; c++) b[(_ = e.attributes[c]).name] = _.value;
    for (c in b) _ = b[c], c == "dangerouslySetInnerHTML" ? m = _ : c == "children" || c in R || c == "value" && "defaultValue" in R || c == "checked" && "defaultChecked" in R || $n(e, c, null, _, r);
    for (c in R) _ = R[c], c == "children" ? f = _ : c == "dangerouslySetInnerHTML" ? p = _ : c == "value" ? k = _ : c == "checked" ? S = _ : l && typeof _ != "function" || b[c] === _ || $n(e, c, _, b[c], r);
    p ? (l || m && (p.__html == m.__html || p.__html == e.innerHTML) || (e.innerHTML = p.__html), t.__k = []) : (m && (e.textContent = ""), (V == "foreignObject" || r == "http://www.w3.org/1998/Math/MathML" && ss.test(V)) && (r = "http://www.w3.org/1999/xhtml"), Zr(u, Ro(f) ? f : [f], t, n, o, r, i, a, i ? i[0] : n.__k && Be(n, 0), l, d), i && i.some(nt)), l && V != "textarea" || (c = "value", V == "progress" && k == null ? e.removeAttribute(c) : k == null || k === e[c] && (V != "progress" || k) || $n(e, c, k, b[c], r), c = "checked", S != null && S != e[c] && $n(e, c, S, b[c], r));
  } else b === R || l && e.data == R || (e.data = R);
  return e;
}
function Ko(e, t, n, o) {
  try {
    typeof e == "function" ? t ? t.__x = e(t) || 1 : o && (o = o.__c || o.__e) && (t = o.__x) && (o.__x = null, typeof t == "function" ? t() : e(null)) : e.current = t;
  } catch (r) {
    C.__e(r, n);
  }
}
function Do(e, t, n) {
  var o, r, i, a;
  if (C.unmount && C.unmount(e), !(o = e.ref) || o.current && o.current != e.__e || Ko(o, null, t, e), o = e.__c) {
    if (o.componentWillUnmount) try {
      o.componentWillUnmount();
    } catch (l) {
      C.__e(l, t);
    }
    o.__P = o.__n = null;
  }
  if (o = e.__k) for (a = 0; a < o.length; a++) o[a] && Do(o[a], t, typeof e.type != "function" || n && !e.props.__P);
  !n && (o = e.__c) && (o = o.__z) && (r = Ln(o, i = [])) && (o == e.__e && i.some(nt), nt(r), nt(o)), n || nt(e.__e), e.__e = e.__c = e.__ = null;
}
function ds(e, t, n) {
  return this.constructor(e, n);
}
function oi(e, t) {
  var n, o, r, i;
  C.__ && C.__(e, t), t.nodeType == 9 && (t = t.documentElement), o = (n = e && 32 & e.__u) ? null : t.__k, t.__k = Xt(X, { children: [e] }), r = [], i = [], Oo(t, t.__k, o || In, In, t.namespaceURI, o ? null : t.firstChild ? Ho.call(t.childNodes) : null, r, o ? o.__e : t.firstChild, n, i), ni(r, t.__k, i), t.__k.props.children = null;
}
C = { __e: function(e, t, n, o) {
  for (var r, i, a; t = t.__; ) if ((r = t.__c) && !(1 & r.__g)) {
    r.__g |= 4;
    try {
      if ((a = (i = r.constructor) && i.getDerivedStateFromError) && r.setState(i.getDerivedStateFromError(e)), r.componentDidCatch && (r.componentDidCatch(e, o || {}), a = 1), a && 8 & r.__g) return void (r.__g |= 2);
    } catch (l) {
      e = l;
    }
  }
  throw Vn = 0, e;
} }, zr = 0, Io = function(e) {
  return e != null && e.constructor === Yt;
}, wt.prototype.setState = function(e, t) {
  var n = this.__s;
  n && n != this.state || (n = this.__s = ot({}, this.state)), typeof e == "function" && (e = e(ot({}, n), this.props)), e && (ot(n, e), this.__v && (t && this.__k.push(t), Wr(this)));
}, wt.prototype.forceUpdate = function(e) {
  this.__v && (this.__g |= 4, e && this.__h.push(e), Wr(this));
}, wt.prototype.render = X, We = [], Vn = 0, Gr = function(e, t) {
  return e.__v.__b - t.__v.__b;
}, Pn = /* @__PURE__ */ Symbol(), Xr = /(PointerCapture)$|Capture$/i, Ao = 0, Vo = {}, as = 0;

// node_modules/preact/hooks/dist/hooks.mjs
var Rn, ue, No, ri, ms = Object.is, Fo = 0, di = [], qo = [], z = C, ii = z.__b, ai = z.__r, si = z.diffed, li = z.__c, ui = z.unmount, ci = z.__;
function mi(e, t) {
  z.__h && z.__h(ue, e, Fo || t), Fo = 0;
  var n = ue.__H || (ue.__H = { __: [], __h: [] });
  return e >= n.__.length && n.__.push({}), n.__[e];
}
function $e(e, t) {
  var n = mi(Rn++, 3);
  !z.__s && hi(n.__H, t) && (n.__P = !0, n.__ = e, n.u = t, ue.__H.__h.push(n));
}
function oe(e) {
  return Fo = 5, Hn(function() {
    return { current: e };
  }, []);
}
function Hn(e, t) {
  var n = mi(Rn++, 7);
  return hi(n.__H, t) && (n.__ = e(), n.__H = t), n.__;
}
function hs() {
  var e;
  do {
    for (; e = qo.shift(); ) try {
      Qt(e);
    } catch (n) {
      z.__e(n, { __: (e = e.__P) && e.__v });
    }
    for (; e = di.shift(); ) {
      var t = e.__H;
      if (e.__P && t) try {
        t.__h.some(Qt), t.__h.some(jo), t.__h = [];
      } catch (n) {
        t.__h = [], z.__e(n, e.__v);
      }
    }
  } while (qo.length);
}
z.__b = function(e) {
  ue = null, ii && ii(e);
}, z.__ = function(e, t) {
  e && t.__k && t.__k.__m && (e.__m = t.__k.__m), ci && ci(e, t);
}, z.__r = function(e) {
  ai && ai(e), Rn = 0;
  var t = (ue = e.__c).__H;
  t && (No == ue ? ue.__h = [] : (t.__h.some(Qt), t.__h.some(jo), Rn = 0), t.__h = [], t.__.some(function(n) {
    n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
  })), No = ue;
}, z.diffed = function(e) {
  si && si(e);
  var t = e.__c;
  t && t.__H && (t.__H.__h.length && pi(di.push(t)), t.__H.__.some(function(n) {
    n.u && (n.__H = n.u);
  })), No = ue = null;
}, z.__c = function(e, t) {
  t.some(function(n) {
    try {
      n.__h.some(Qt), n.__h = n.__h.filter(function(o) {
        return !o.__ || jo(o);
      });
    } catch (o) {
      n.__h = [function() {
        throw o;
      }];
    }
  }), li && li(e, t);
}, z.unmount = function(e) {
  ui && ui(e);
  var t, n, o = e.__c;
  o && o.__H && (o.__H.__.some(function(r) {
    try {
      if (r.__P && r.__c) {
        if (n === void 0) {
          for (n = e.__; n && (!n.__c || !n.__c.__P); ) n = n.__;
          n = n && n.__c;
        }
        r.__P = n, pi(qo.push(r));
      } else Qt(r);
    } catch (i) {
      t = i;
    }
  }), o.__H = void 0, t && z.__e(t, o.__v));
};
var fi = typeof requestAnimationFrame == "function";
function vs(e) {
  var t, n = function() {
    clearTimeout(o), fi && cancelAnimationFrame(t), setTimeout(e);
  }, o = setTimeout(n, 35);
  fi && (t = requestAnimationFrame(n));
}
function pi(e) {
  e != 1 && ri == z.requestAnimationFrame || ((ri = z.requestAnimationFrame) || vs)(hs);
}
function Qt(e) {
  var t = ue, n = e.__c;
  typeof n == "function" && (e.__c = void 0, n()), ue = t;
}
function jo(e) {
  var t = ue;
  e.__c = e.__(), ue = t;
}
function hi(e, t) {
  return !e || e.length != t.length || t.some(function(n, o) {
    return !ms(n, e[o]);
  });
}

// node_modules/@preact/signals-core/dist/signals-core.module.js
var gs = /* @__PURE__ */ Symbol.for("preact-signals");
function Nn() {
  if (Oe > 1)
    Oe--;
  else {
    var e, t = !1;
    for ((function() {
      var r = Kn;
      for (Kn = void 0; r !== void 0; ) {
        var i = r.S;
        if (i.v === r.v) for (var a = i.t; a !== void 0; a = a.x) a.i === r.i && (a.i = i.i);
        r = r.o;
      }
    })(); Zt !== void 0; ) {
      var n = Zt;
      for (Zt = void 0, On++; n !== void 0; ) {
        var o = n.u;
        if (n.u = void 0, n.f &= -3, !(8 & n.f) && gi(n)) try {
          n.c();
        } catch (r) {
          t || (e = r, t = !0);
        }
        n = o;
      }
    }
    if (On = 0, Oe--, t) throw e;
  }
}
function Fn(e) {
  if (Oe > 0) return e();
  Uo = ++bs, Oe++;
  try {
    return e();
  } finally {
    Nn();
  }
}
var Jt, N = void 0;
function se(e) {
  var t = N, n = Jt;
  N = void 0, Jt = void 0;
  try {
    return e();
  } finally {
    N = t, Jt = n;
  }
}
var Zt = void 0, Oe = 0, On = 0, bs = 0, Uo = 0, Kn = void 0, Dn = 0;
function vi(e) {
  if (N !== void 0) {
    var t = e.n;
    if (t === void 0 || t.t !== N)
      return t = { i: 0, S: e, p: N.s, n: void 0, t: N, e: void 0, x: void 0, r: t }, N.s !== void 0 && (N.s.n = t), N.s = t, e.n = t, 32 & N.f && e.S(t), t;
    if (t.i === -1)
      return t.i = 0, t.n !== void 0 && (t.n.p = t.p, t.p !== void 0 && (t.p.n = t.n), t.p = N.s, t.n = void 0, N.s.n = t, N.s = t), t;
  }
}
function Y(e, t) {
  this.v = e, this.i = 0, this.n = void 0, this.t = void 0, this.l = 0, this.W = t?.watched, this.Z = t?.unwatched, this.name = t?.name;
}
Y.prototype.brand = gs;
Y.prototype.h = function() {
  return !0;
};
Y.prototype.S = function(e) {
  var t = this, n = this.t;
  n !== e && e.e === void 0 && (e.x = n, this.t = e, n !== void 0 ? n.e = e : se(function() {
    var o;
    (o = t.W) == null || o.call(t);
  }));
};
Y.prototype.U = function(e) {
  var t = this;
  if (this.t !== void 0) {
    var n = e.e, o = e.x;
    n !== void 0 && (n.x = o, e.e = void 0), o !== void 0 && (o.e = n, e.x = void 0), e === this.t && (this.t = o, o === void 0 && se(function() {
      var r;
      (r = t.Z) == null || r.call(t);
    }));
  }
};
Y.prototype.subscribe = function(e) {
  var t = this;
  return T(function() {
    var n = t.value;
    se(function() {
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
  return se(function() {
    return e.value;
  });
};
Object.defineProperty(Y.prototype, "value", { get: function() {
  var e = vi(this);
  return e !== void 0 && (e.i = this.i), this.v;
}, set: function(e) {
  if (e !== this.v) {
    if (On > 100) throw new Error("Cycle detected");
    (function(n) {
      Oe !== 0 && On === 0 && n.l !== Uo && (n.l = Uo, Kn = { S: n, v: n.v, i: n.i, o: Kn });
    })(this), this.v = e, this.i++, Dn++, Oe++;
    try {
      for (var t = this.t; t !== void 0; t = t.x) t.t.N();
    } finally {
      Nn();
    }
  }
} });
function g(e, t) {
  return new Y(e, t);
}
function gi(e) {
  for (var t = e.s; t !== void 0; t = t.n) if (t.S.i !== t.i || !t.S.h() || t.S.i !== t.i) return !0;
  return !1;
}
function bi(e) {
  for (var t = e.s; t !== void 0; t = t.n) {
    var n = t.S.n;
    if (n !== void 0 && (t.r = n), t.S.n = t, t.i = -1, t.n === void 0) {
      e.s = t;
      break;
    }
  }
}
function yi(e) {
  for (var t = e.s, n = void 0; t !== void 0; ) {
    var o = t.p;
    t.i === -1 ? (t.S.U(t), o !== void 0 && (o.n = t.n), t.n !== void 0 && (t.n.p = o)) : n = t, t.S.n = t.r, t.r !== void 0 && (t.r = void 0), t = o;
  }
  e.s = n;
}
function rt(e, t) {
  Y.call(this, void 0, t), this.x = e, this.s = void 0, this.g = Dn - 1, this.f = 4;
}
rt.prototype = new Y();
rt.prototype.h = function() {
  if (this.f &= -3, 1 & this.f) return !1;
  if ((36 & this.f) == 32 || (this.f &= -5, this.g === Dn)) return !0;
  if (this.g = Dn, this.f |= 1, this.i > 0 && !gi(this))
    return this.f &= -2, !0;
  var e = N;
  try {
    bi(this), N = this;
    var t = this.x();
    (16 & this.f || this.v !== t || this.i === 0) && (this.v = t, this.f &= -17, this.i++);
  } catch (n) {
    this.v = n, this.f |= 16, this.i++;
  }
  return N = e, yi(this), this.f &= -2, !0;
};
rt.prototype.S = function(e) {
  if (this.t === void 0) {
    this.f |= 36;
    for (var t = this.s; t !== void 0; t = t.n) t.S.S(t);
  }
  Y.prototype.S.call(this, e);
};
rt.prototype.U = function(e) {
  if (this.t !== void 0 && (Y.prototype.U.call(this, e), this.t === void 0)) {
    this.f &= -33;
    for (var t = this.s; t !== void 0; t = t.n) t.S.U(t);
  }
};
rt.prototype.N = function() {
  if (!(2 & this.f)) {
    this.f |= 6;
    for (var e = this.t; e !== void 0; e = e.x) e.t.N();
  }
};
Object.defineProperty(rt.prototype, "value", { get: function() {
  if (1 & this.f) throw new Error("Cycle detected");
  var e = vi(this);
  if (this.h(), e !== void 0 && (e.i = this.i), 16 & this.f) throw this.v;
  return this.v;
} });
function G(e, t) {
  return new rt(e, t);
}
function _i(e) {
  var t = e.j;
  if (e.j = void 0, typeof t == "function") {
    Oe++;
    var n = N;
    N = void 0;
    try {
      t();
    } catch (o) {
      throw e.f &= -2, e.f |= 8, Wo(e), o;
    } finally {
      N = n, Nn();
    }
  }
}
function Wo(e) {
  for (var t = e.s; t !== void 0; t = t.n) t.S.U(t);
  e.x = void 0, e.s = void 0, _i(e);
}
function ys(e) {
  if (N !== this) throw new Error("Out-of-order effect");
  yi(this), N = e, this.f &= -2;
  try {
    8 & this.f && Wo(this);
  } finally {
    Nn();
  }
}
function kt(e, t) {
  this.x = e, this.j = void 0, this.s = void 0, this.u = void 0, this.f = 32, this.name = t?.name, Jt && Jt.push(this);
}
kt.prototype.c = function() {
  var e = this.S();
  try {
    if (8 & this.f || this.x === void 0) return;
    var t = this.x();
    typeof t == "function" && (this.j = t);
  } finally {
    e();
  }
};
kt.prototype.S = function() {
  if (1 & this.f) throw new Error("Cycle detected");
  this.f |= 1, this.f &= -9, _i(this), bi(this), Oe++;
  var e = N;
  return N = this, ys.bind(this, e);
};
kt.prototype.N = function() {
  2 & this.f || (this.f |= 2, this.u = Zt, Zt = this);
};
kt.prototype.d = function() {
  this.f |= 8, 1 & this.f || Wo(this);
};
kt.prototype.dispose = function() {
  this.d();
};
function T(e, t) {
  var n = new kt(e, t);
  try {
    n.c();
  } catch (r) {
    throw n.d(), r;
  }
  var o = n.d.bind(n);
  return o[Symbol.dispose] = o, o;
}

// node_modules/@preact/signals/dist/signals.module.js
var Bo, tn, qn, _s = typeof window < "u" && !!window.__PREACT_SIGNALS_DEVTOOLS__, wi = [], ki = [];
T(function() {
  Bo = this.N;
})();
function xt(e, t) {
  C[e] = t.bind(null, C[e] || function() {
  });
}
function en(e) {
  if (qn) {
    var t = qn;
    qn = void 0, t();
  }
  qn = e && e.S();
}
function xi(e) {
  var t = this, n = e.data, o = it(n);
  o.name = "ReactiveDom", o.value = n;
  var r = Hn(function() {
    for (var l = t, d = t.__v; d = d.__; ) if (d.__c) {
      d.__c.__$f |= 4;
      break;
    }
    var u = G(function() {
      var f = o.value.value;
      return f === 0 ? 0 : f === !0 ? "" : f || "";
    }), c = G(function() {
      return !Array.isArray(u.value) && !Io(u.value);
    }), p = T(function() {
      if (this.N = Si, c.value) {
        var f = u.value;
        l.__v && l.__v.__e && l.__v.__e.nodeType === 3 && (l.__v.__e.data = f);
      }
    }), m = t.__$u.d;
    return t.__$u.d = function() {
      p(), m.call(this);
    }, [c, u];
  }, []), i = r[0], a = r[1];
  return i.value ? a.peek() : a.value;
}
xi.displayName = "ReactiveTextNode";
Object.defineProperties(Y.prototype, { constructor: { configurable: !0, value: Yr(X, null).constructor }, type: { configurable: !0, value: xi }, props: { configurable: !0, get: function() {
  var e = this;
  return { data: { get value() {
    return e.value;
  } } };
} }, __b: { configurable: !0, value: 1 } });
xt("__b", function(e, t) {
  if (en(), tn = void 0, typeof t.type == "string") {
    var n, o = t.props;
    for (var r in o) if (r !== "children") {
      var i = o[r];
      i instanceof Y && (n || (t.__np = n = {}), n[r] = i, o[r] = i.peek());
    }
  }
  e(t);
});
xt("__r", function(e, t) {
  if (e(t), t.type !== X) {
    en();
    var n, o = t.__c;
    o && (o.__$f &= -2, (n = o.__$u) === void 0 && (o.__$u = n = (function(r, i) {
      var a;
      return T(function() {
        a = this;
      }, { name: i }), a.c = r, a;
    })(/* @__PURE__ */ (function(r) {
      return function() {
        var i;
        _s && ((i = this.y) == null || i.call(this)), r.__$f |= 1, r.setState({});
      };
    })(o), typeof t.type == "function" ? t.type.displayName || t.type.name : ""))), tn = o, en(n);
  }
});
xt("__e", function(e, t, n, o) {
  en(), tn = void 0, e(t, n, o);
});
xt("diffed", function(e, t) {
  en(), tn = void 0;
  var n;
  if (typeof t.type == "string" && (n = t.__e)) {
    var o = t.__np, r = t.props, i = n.U;
    if (i) for (var a in i) {
      var l = i[a];
      l === void 0 || o && a in o || (l.d(), i[a] = void 0);
    }
    if (o) {
      i || (i = {}, n.U = i);
      for (var d in o) {
        var u = i[d], c = o[d];
        u === void 0 ? (u = ws(n, d, c, r), i[d] = u) : u.o(c, r);
      }
    }
  }
  e(t);
});
function ws(e, t, n, o) {
  var r = t in e && e.ownerSVGElement === void 0, i = g(n);
  return { o: function(a, l) {
    i.value = a, o = l;
  }, d: T(function() {
    this.N = Si;
    var a = i.value.value;
    o[t] !== a && (o[t] = a, r ? e[t] = a : a != null && (a !== !1 || t[4] === "-") ? e.setAttribute(t, a) : e.removeAttribute(t));
  }) };
}
xt("unmount", function(e, t) {
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
      var l = t.props;
      for (var d in a) l[d] = a[d];
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
xt("__h", function(e, t, n, o) {
  o < 3 && (t.__$f |= 2), e(t, n, o);
});
wt.prototype.shouldComponentUpdate = function(e, t) {
  if (this.__R) return !0;
  var n = this.__$u, o = n && n.s !== void 0;
  for (var r in t) return !0;
  if (this.__f || typeof this.u == "boolean" && this.u === !0) {
    var i = 2 & this.__$f;
    if (!(o || i || 4 & this.__$f) || 1 & this.__$f) return !0;
  } else if (!(o || 4 & this.__$f) || 3 & this.__$f) return !0;
  for (var a in e) if (a !== "__source" && e[a] !== this.props[a]) return !0;
  for (var l in this.props) if (!(l in e)) return !0;
  return !1;
};
function it(e, t) {
  return Hn(function() {
    return g(e, t);
  }, []);
}
var ks = typeof requestAnimationFrame > "u" ? setTimeout : function(e) {
  var t = function() {
    clearTimeout(n), cancelAnimationFrame(o), e();
  }, n = setTimeout(t, 35), o = requestAnimationFrame(t);
}, xs = function(e) {
  queueMicrotask(function() {
    queueMicrotask(e);
  });
};
function Ss() {
  Fn(function() {
    for (var e; e = wi.shift(); ) Bo.call(e);
  });
}
function Ms() {
  wi.push(this) === 1 && (C.requestAnimationFrame || ks)(Ss);
}
function Cs() {
  Fn(function() {
    for (var e; e = ki.shift(); ) Bo.call(e);
  });
}
function Si() {
  ki.push(this) === 1 && (C.requestAnimationFrame || xs)(Cs);
}
function Mi(e, t) {
  var n = oe(e);
  n.current = e;
  var o = tn;
  $e(function() {
    return T(function() {
      if (this.N = Ms, !(o && 8 & o.__$f)) return n.current();
    }, t);
  }, []);
}

// src/store.ts
var jn = /* @__PURE__ */ new Set(), St = (e) => typeof e == "object" && e !== null && !Array.isArray(e);
function rn(e, t) {
  if (!St(e) || !St(t)) return t;
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
    jn.add(this), this.show();
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
    this.own.size === 0 && jn.delete(this), n && this.show();
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
}, Pe = class {
  /** Numbers of the entries there are, ascending; changes only when one comes or goes. */
  ids = g([]);
  entries = /* @__PURE__ */ new Map();
  get(t) {
    if (t == null) return;
    let n = this.entries.get(t);
    if (n) return n.shown.value;
    this.ids.value;
  }
  entry(t) {
    return this.entries.get(t);
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
      r === null ? n = this.entries.delete(i) || n : a ? a.receive(r) : (this.entries.set(i, new nn(r)), n = !0);
    }
    n && this.number();
  }
  number() {
    this.ids.value = [...this.entries.keys()].sort((t, n) => t - n);
  }
}, w = new Pe(), O = new Pe(), be = new Pe(), Mt = new Pe(), Ct = new Pe(), Et = new Pe(), Ke = new Pe(), at = new Pe(), on = {
  lamps: w,
  groups: O,
  things: be,
  materials: Mt,
  views: Ct,
  looks: Et,
  meters: Ke,
  grids: at
}, ee = g(null), an = g([]), Me = g([]), st = g({ undo: null, redo: null, steps: 0 }), lt = g({ state: "clean", file: "" }), te = g({ you: !0, name: null }), Le = g(null), Un = new nn({
  ev: null,
  metered: !1,
  tone: "filmic",
  white: null,
  false_color: null
}), ut = Un.shown, zo = {
  scene: ee,
  layers: an,
  solo: Me,
  history: st,
  saved: lt,
  editor: te,
  status: Le
};
function Ci(e) {
  jn.clear();
  for (let [t, n] of Object.entries(on)) n.whole(e[t]);
  for (let [t, n] of Object.entries(zo)) t in e && (n.value = e[t]);
  St(e.display) && Un.receive(e.display);
}
function Ei(e, t) {
  for (let [n, o] of Object.entries(e))
    n in on ? on[n].patch(o) : n === "display" ? Un.receive(o) : n in zo && (zo[n].value = o);
  Tt(t);
}
function Tt(e) {
  for (let t of [...jn]) t.release(e);
}
function Ti(e, t) {
  for (let [n, o] of Object.entries(e))
    if (n in on && St(o))
      for (let [r, i] of Object.entries(o)) {
        let a = on[n].entry(Number(r));
        a && St(i) && t(a, i);
      }
    else n === "display" && St(o) && t(Un, o);
}
var Go = (e, t) => Ti(e, (n, o) => n.keep(o, t)), Wn = (e, t) => Ti(e, (n, o) => n.settle(o, t));
function ye(e) {
  let t = O.get(e.group);
  return e.on && !e.parked && (t?.on ?? !0) ? e.level * (t?.level ?? 1) : 0;
}
var $i = G(() => {
  let e = w.all();
  return e.length > 0 && e.every(([, t]) => ye(t) === 0);
});
function Es(e, t) {
  let n = t.trim().toLowerCase();
  return e.all().filter(([, o]) => !n || o.name.toLowerCase().includes(n));
}

// src/say.ts
var ct = g([]), Ts = 0;
function Q(e, t = "plain") {
  if (ct.peek().find((r) => r.text === e)) return;
  let o = ++Ts;
  ct.value = [...ct.peek().slice(-2), { id: o, text: e, tone: t }], setTimeout(() => Xo(o), t === "warn" ? 8e3 : 4e3);
}
function Xo(e) {
  ct.value = ct.peek().filter((t) => t.id !== e);
}

// src/counters.ts
var le = {
  frame: 0,
  seqApplied: 0,
  frames: [],
  sent: [],
  entered: 0,
  firstDrawn: 0
}, Pi = 0;
for (let e of ["input", "pointermove", "pointerdown", "keydown", "wheel"])
  addEventListener(e, (t) => Pi = t.timeStamp, { capture: !0, passive: !0 });
function Li(e, t) {
  le.sent.push({ seq: e, what: t, at: performance.now(), input: Pi }), le.sent.length > 1024 && le.sent.shift();
}
function Vi(e) {
  le.frame = e.frame, le.seqApplied = e.seq, le.firstDrawn ||= e.drawn, le.frames.push(e), le.frames.length > 1024 && le.frames.shift(), requestAnimationFrame(() => {
    let t = new MessageChannel();
    t.port1.onmessage = () => {
      e.painted = performance.now(), t.port1.close();
    }, t.port2.postMessage(0);
  });
}
window.__desk = le;

// src/wire.ts
var U = g("entering"), un = g(0), me = g("edit"), Jo = g(null), De = g(0), Ii = () => null, Ai = (e) => {
  Ii = e;
}, Bn = /* @__PURE__ */ new Map(), ze = null, sn = 0, Yo = null, ln = 0, $t = "", zn = !1;
function Ce(e, t) {
  let n = Bn.get(e) ?? /* @__PURE__ */ new Set();
  return Bn.set(e, n.add(t)), () => n.delete(t);
}
function F(e) {
  return !ze || ze.readyState !== WebSocket.OPEN || U.peek() !== "open" ? 0 : (sn += 1, ze.send(JSON.stringify({ ...e, seq: sn })), e.do !== "ack" && Li(sn, e.do), sn);
}
var $s = 0, ft = /* @__PURE__ */ new Map();
function Ee(e, t, n, o = () => {
}) {
  let r = ++$s, i = Ce("answer", (l) => {
    l.id === r && (l.done !== !1 && i(), n(l));
  }), a = F({ do: "ask", id: r, what: e, ...t });
  if (!a)
    return i(), o("There is no connection to the program."), i;
  ft.set(a, (l) => {
    i(), o(l);
  });
  for (let l of ft.keys()) {
    if (l > a - 300) break;
    ft.delete(l);
  }
  return i;
}
function Ps(e) {
  switch (e.is) {
    case "hello":
      if (ln = 0, Yo !== null && e.build !== Yo) {
        U.value = "renewed", ze?.close();
        return;
      }
      Yo = e.build, me.value = e.role === "watch" ? "watch" : "edit", Jo.value = e.you === void 0 ? null : String(e.you), De.value = 0, ft.clear(), U.value = "open";
      break;
    case "state":
      Ci(e.state ?? e);
      break;
    case "patch":
      Qo(e.seq), Ei(e.patch ?? {}, De.value);
      break;
    case "status":
      Le.value = e;
      break;
    case "refused":
      if (Qo(e.seq), Tt(De.value), ft.has(e.seq)) {
        ft.get(e.seq)?.(e.why ?? ""), ft.delete(e.seq);
        return;
      }
      break;
    case "event":
      e.what === "bye" && (zn = !0);
      break;
  }
  for (let t of [...Bn.get(e.is) ?? []]) t(e);
}
function Qo(e) {
  typeof e == "number" && e > De.value && (De.value = e);
}
async function Ri() {
  if (!$t) return "in";
  try {
    return (await fetch("/enter", {
      method: "POST",
      headers: { "content-type": "application/json" },
      body: JSON.stringify({ key: $t })
    })).ok ? "in" : "denied";
  } catch {
    return "away";
  }
}
function Hi() {
  let e = location.protocol === "https:" ? "wss" : "ws", t = new WebSocket(`${e}://${location.host}/wire`);
  t.binaryType = "arraybuffer";
  let n = !1;
  ze = t, Bn.get("line")?.forEach((o) => o({ is: "line" })), t.onmessage = (o) => {
    if (t !== ze) return;
    if (typeof o.data != "string") {
      let i = Ii(o.data);
      i && Qo(i.seq);
      return;
    }
    let r = JSON.parse(o.data);
    r.is === "hello" && (n = !0, sn = 0), Ps(r);
  }, t.onclose = () => {
    t === ze && (ze = null, U.value !== "renewed" && Ls(n));
  };
}
async function Ls(e) {
  if (Tt(1 / 0), !e && await Vs()) {
    let o = await Ri();
    if (o === "denied" || o === "in" && ln > 4 && !$t) {
      U.value = "denied";
      return;
    }
  }
  ln += 1;
  let t = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
  ln > 3 && t && (zn = !0), U.value = zn ? "ended" : "lost";
  let n = Math.min(5, ln);
  for (let o = n; o > 0; o--)
    un.value = o, await new Promise((r) => setTimeout(r, 1e3));
  un.value = 0, Hi();
}
async function Vs() {
  try {
    return (await fetch("/", { method: "HEAD", cache: "no-store" })).ok;
  } catch {
    return !1;
  }
}
async function Oi() {
  let e = location.hash.slice(1);
  if (e ? ($t = e, sessionStorage.setItem("lampyris-key", $t), window.history.replaceState(null, "", location.pathname + location.search)) : $t = sessionStorage.getItem("lampyris-key") ?? "", le.entered = performance.now(), e && await Ri() === "denied") {
    U.value = "denied";
    return;
  }
  Hi();
}
Ce("hello", () => zn = !1);

// src/gesture.ts
var Pt = 0, Ni = /* @__PURE__ */ new Set(), Fi = (e) => {
  Ni.add(e);
}, cn = /* @__PURE__ */ new Set();
function Gn() {
  return U.value !== "open" ? "There is no connection to the program: nothing was changed." : me.value === "watch" ? "You are watching. Ask for the pen to change things." : te.value.you ? null : `${te.value.name ?? "Somebody else"} has the pen. Take it to change things.`;
}
var Ki = (e) => (e.length > 120 ? `${e.slice(0, 119)}…` : e).replace(/[\u0000-\u001f]/g, " "), Ne = class {
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
    this.state === "over" || !this.begin() || (Go(t, 1 / 0), this.touched = rn(this.touched, t), this.waiting = rn(this.waiting ?? {}, t), this.under <= De.peek() && this.flush());
  }
  /** Any other message that belongs to this step. */
  also(t) {
    this.state === "over" || !this.begin() || (this.flush(), this.last = F(t));
  }
  end(t) {
    this.state === "held" && (this.flush(), Wn(this.touched, this.last), this.finish({ do: "end", ...t ? { label: Ki(t) } : {} })), this.state = "over";
  }
  cancel() {
    this.state === "held" && (this.waiting = null, Wn(this.touched, 0), this.finish({ do: "cancel" }), Tt(0)), this.state = "over";
  }
  /** The server has followed so far. */
  followed() {
    this.waiting && this.under <= De.peek() && this.flush();
  }
  /** The line is gone, and with it what was held. */
  drop() {
    this.state = "over", cn.delete(this), Pt = 0;
  }
  begin() {
    if (this.state === "held") return !0;
    let t = se(Gn);
    return t ? (Q(t, "warn"), this.state = "over", !1) : (this.state = "held", cn.add(this), Pt === 0 && Ni.forEach((n) => n()), Pt++ === 0 && (this.last = F({ do: "begin", label: Ki(this.label) })), !0);
  }
  flush() {
    this.waiting && (this.under = this.last = F({ do: "set", patch: this.waiting }), this.waiting = null);
  }
  finish(t) {
    cn.delete(this), Pt = Math.max(0, Pt - 1), Pt === 0 && F(t);
  }
};
function ce(e, t) {
  let n = new Ne(e);
  n.set(t), n.end();
}
function Xn(e, t) {
  let n = new Ne(e);
  n.also(t), n.end();
}
function Lt(e) {
  se(() => U.value) === "open" && (Go({ display: e }, 1 / 0), Wn({ display: e }, F({ do: "display", patch: e })));
}
var Ve = null;
function Zo(e, t, n) {
  Ve && Ve.key !== e && Di(), Ve ??= { key: e, gesture: new Ne(t), timer: 0 }, Ve.gesture.set(n), clearTimeout(Ve.timer), Ve.timer = window.setTimeout(Di, 700);
}
function Di() {
  Ve && (clearTimeout(Ve.timer), Ve.gesture.end(), Ve = null);
}
T(() => {
  De.value, se(() => [...cn].forEach((e) => e.followed()));
});
T(() => {
  U.value !== "open" && [...cn].forEach((e) => e.drop());
});

// src/vec.ts
var M = (e, t) => [e[0] + t[0], e[1] + t[1], e[2] + t[2]], A = (e, t) => [e[0] - t[0], e[1] - t[1], e[2] - t[2]], x = (e, t) => [e[0] * t, e[1] * t, e[2] * t], K = (e, t) => e[0] * t[0] + e[1] * t[1] + e[2] * t[2], fe = (e, t) => [
  e[1] * t[2] - e[2] * t[1],
  e[2] * t[0] - e[0] * t[2],
  e[0] * t[1] - e[1] * t[0]
], Fe = (e) => Math.hypot(e[0], e[1], e[2]), Te = (e, t) => Fe(A(e, t)), Is = (e, t, n) => M(x(e, 1 - n), x(t, n));
function q(e, t = [0, 0, 1]) {
  let n = Fe(e);
  return n > 1e-12 ? x(e, 1 / n) : t;
}
function pt(e) {
  let t = Math.abs(e[0]) < 0.7 * Fe(e) ? [1, 0, 0] : [0, 1, 0];
  return q(fe(t, e));
}
function fn(e, t, n) {
  let o = Math.cos(n), r = Math.sin(n);
  return M(M(x(e, o), x(fe(t, e), r)), x(t, K(t, e) * (1 - o)));
}
function Vt([e, t]) {
  return Array.from({ length: 8 }, (n, o) => [
    o & 1 ? t[0] : e[0],
    o & 2 ? t[1] : e[1],
    o & 4 ? t[2] : e[2]
  ]);
}
var Ge = ([e, t]) => Is(e, t, 0.5);

// src/camera.ts
var er = Math.PI / 180, Yn = 89 * er;
function It(e, t, n) {
  let o = q(A(e.target, e.eye), [0, 0, -1]), r = q(fe(o, e.up), pt(o)), i = fe(r, o), a = e.height != null && e.height > 0, l = a ? e.height / n : 2 * Math.tan(e.fov * er * 0.5) / n;
  return { eye: e.eye, forward: o, side: r, up: i, width: t, height: n, pixel: l, parallel: a };
}
function pn(e, t) {
  let n = A(t, e.eye), o = K(n, e.forward), r = e.parallel ? e.pixel : e.pixel * o;
  return [e.width / 2 + K(n, e.side) / r, e.height / 2 - K(n, e.up) / r, o];
}
function As(e, t, n) {
  let o = (t - e.width / 2) * e.pixel, r = (e.height / 2 - n) * e.pixel, i = M(x(e.side, o), x(e.up, r));
  return e.parallel ? { origin: M(e.eye, i), direction: e.forward } : { origin: e.eye, direction: q(M(e.forward, i)) };
}
function qi(e, t, n, o) {
  let r = A(e.target, e.eye), i = Math.max(Fe(r), 1e-3), a = Math.asin(Math.max(-1, Math.min(1, K(q(r), t)))), l = A(r, x(t, K(r, t))), d = q(Fe(l) > 1e-6 * i ? l : A(e.up, x(t, K(e.up, t))), pt(t)), u = Math.max(-Yn, Math.min(Yn, a + o)), c = fn(d, t, n), p = M(x(c, Math.cos(u)), x(t, Math.sin(u)));
  return { ...e, up: t, target: M(e.eye, x(p, i)) };
}
function ji(e, t, n, o, r) {
  let i = A(e.target, e.eye), a = A(i, x(t, K(i, t))), l = q(Fe(a) > 1e-6 ? a : e.up, pt(t)), d = q(fe(l, t)), u = M(M(x(l, n), x(d, o)), x(t, r));
  return Xe(e, u);
}
function Ui(e, t, n, o, r) {
  let i = q(A(e.target, e.eye)), a = q(fe(i, e.up), pt(i));
  return Xe(e, M(M(x(i, n), x(a, o)), x(t, r)));
}
function Xe(e, t) {
  return { ...e, eye: M(e.eye, t), target: M(e.target, t) };
}
function Wi(e, t, n, o, r) {
  let i = q(A(e.target, e.eye)), a = Math.asin(Math.max(-1, Math.min(1, K(i, t)))), l = Math.max(-Yn, Math.min(Yn, a + r)), d = q(fe(i, t), q(fe(i, e.up), pt(i))), u = (c) => fn(fn(c, d, l - a), t, o);
  return {
    ...e,
    up: t,
    eye: M(n, u(A(e.eye, n))),
    target: M(n, u(A(e.target, n)))
  };
}
function Bi(e, t, n, o, r) {
  let i = t.parallel ? t.pixel : t.pixel * r;
  return Xe(e, M(x(t.side, -n * i), x(t.up, o * i)));
}
function Qn(e, t, n, o, r) {
  let i = A(t, e.eye), a = Fe(i);
  if (a < 1e-9) return e;
  let l = a * (1 - n);
  return r ? l = Math.sign(l) * Math.max(Math.abs(l), 0.5 * Math.abs(1 - n)) : l > 0 && (l = Math.max(0, Math.min(l, a - o))), Xe(e, x(i, l / a));
}
function Jn(e, t, n, o, r) {
  let i = Math.max(0.05, Math.min(1e5, (e.height ?? 1) * r)), a = (1 - i / (e.height ?? 1)) * t.pixel, l = M(
    x(t.side, (n - t.width / 2) * a),
    x(t.up, (t.height / 2 - o) * a)
  );
  return { ...Xe(e, l), height: i };
}
function zi(e, t, n = 0.4) {
  let o = Ge(t), r = Math.max(Te(t[0], t[1]) / 2, 0.15), i = q(A(e.eye, e.target));
  if (e.height) {
    let l = K(A(e.eye, o), i);
    return { ...e, eye: M(o, x(i, l)), target: o, height: r * 3 };
  }
  let a = Math.max(1.5 * r / Math.tan(e.fov * er * 0.5), n + r);
  return { ...e, eye: M(o, x(i, a)), target: o };
}
var Rs = ["plan", "ceiling", "north", "east", "south", "west"];
function Gi(e) {
  let t = Math.abs(e[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], n = q(fe(e, t));
  return { right: q(fe(n, e)), ahead: n };
}
function Xi(e, t, n, o) {
  let { right: r, ahead: i } = Gi(n), a = Ge(t), l = (_) => Math.abs(K(A(t[1], t[0]), _)), u = {
    plan: { forward: x(n, -1), up: i, side: r, cut: 0.15 },
    ceiling: { forward: n, up: x(i, -1), side: r, cut: 0.35 },
    north: { forward: i, up: n, side: r, cut: 0.25 },
    south: { forward: x(i, -1), up: n, side: r, cut: 0.25 },
    east: { forward: r, up: n, side: i, cut: 0.25 },
    west: { forward: x(r, -1), up: n, side: i, cut: 0.25 }
  }[e], c = l(u.forward), p = 1, m = A(a, x(u.forward, c / 2 + p)), f = 1.08 * Math.max(l(u.up), l(u.side) / o, 0.1);
  return { eye: m, target: a, up: u.up, fov: 50, height: f, near: p + c * u.cut };
}
function dn(e, t) {
  let n = (r, i) => Te(r, i) < 1e-4, o = (r, i) => Math.abs((r ?? -1) - (i ?? -1)) < 1e-4;
  return n(e.eye, t.eye) && n(e.target, t.target) && n(e.up, t.up) && o(e.fov, t.fov) && o(e.height, t.height) && o(e.near, t.near);
}

// src/frames.ts
var W = g(null), Rt = g(0), Yi = ["moving", "settled", "final"], Qi = 32, At = /* @__PURE__ */ new Map(), Ie = null, tr = null, nr = !1, dt = null;
function Hs(e) {
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
function Os(e) {
  let t = Hs(e);
  return t ? (dt && F({ do: "ack", frame: dt.head.frame }), dt = { ...t, bytes: e, received: performance.now() }, nr || Ks(), t.head) : null;
}
async function Ks() {
  for (nr = !0; dt; ) {
    let { head: e, mime: t, bytes: n, received: o } = dt;
    dt = null;
    try {
      let r = await createImageBitmap(new Blob([new Uint8Array(n, Qi)], { type: t }));
      Ds(e, r, n.byteLength, o);
    } catch {
    }
    F({ do: "ack", frame: e.frame });
  }
  nr = !1;
}
function Ds(e, t, n, o) {
  let r = performance.now();
  Ie && tr && ((Ie.width !== t.width || Ie.height !== t.height) && (Ie.width = t.width, Ie.height = t.height), tr.drawImage(t, 0, 0)), t.close();
  let i = At.get(e.camera) ?? W.peek()?.camera;
  i && (W.value = { head: e, camera: i }), Ns(), Vi({
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
var Zn = [];
function Ns() {
  let e = performance.now();
  Zn = Zn.filter((t) => e - t < 1e3), Zn.push(e), Rt.value = Zn.length;
}
function or(e) {
  Ie = e, tr = e?.getContext("2d", { alpha: !1 }) ?? null;
}
function Ji() {
  if (!Ie || !W.peek()) return null;
  let e = document.createElement("canvas");
  return e.width = Ie.width, e.height = Ie.height, e.getContext("2d", { alpha: !1 })?.drawImage(Ie, 0, 0), e;
}
Ai(Os);
Ce("camera", (e) => {
  At.set(e.number, e);
  for (let t of At.keys()) {
    if (At.size <= 64) break;
    At.delete(t);
  }
});
Ce("line", () => {
  At.clear(), dt = null;
});

// src/prefs.ts
var Zi = "lampyris-";
function pe(e, t) {
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
var rr = pe("theme", "dark"), ir = pe("house-lights", 1), eo = pe("hands", "default"), ar = pe("walking", "walk"), sr = pe("panels", !0), Ht = pe("listing", "faders"), to = pe("travel", "square"), Ot = pe("candles", "lx"), lr = pe("single-keys", !0), ur = pe("lamp-marks", !0), Fs = pe("maintenance", 1), Ye = pe("fine", !1), cr = pe("fade", 1), qs = typeof matchMedia == "function" && matchMedia("(pointer: coarse)").matches, Ae = pe("look-only", qs);

// src/select.ts
var E = g(null), ne = g(null), D = g(null), js = g("move"), re = G(() => {
  let e = E.value;
  return e?.kind === "lamp" ? e.ids.filter((t) => w.get(t)) : e?.kind === "group" ? e.ids.flatMap((t) => O.get(t)?.lamps ?? []) : [];
});
function _e(e, t, n = "only") {
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
function no() {
  E.value = null;
}
function ea(e, t, n) {
  let o = E.peek(), r = o?.kind === e ? t.indexOf(o.ids[o.ids.length - 1]) : -1;
  if (r < 0) return _e(e, n);
  let i = t.indexOf(n), [a, l] = r < i ? [r, i] : [i, r], d = t.slice(a, l + 1), u = (o?.ids ?? []).filter((c) => !d.includes(c));
  E.value = { kind: e, ids: [...u, ...r < i ? d : d.reverse()] };
}
function Us(e) {
  let t = E.peek(), n = t?.kind ?? "lamp", o = n === "lamp" ? w.ids.peek() : n === "thing" ? be.ids.peek() : O.ids.peek();
  if (!o.length) return;
  let r = t ? o.indexOf(t.ids[t.ids.length - 1]) : e > 0 ? -1 : 0;
  _e(n, o[(r + e + o.length) % o.length]);
}
function ta(e, t) {
  switch (e) {
    case "lamp":
      return w.get(t)?.name ?? `lamp ${t}`;
    case "group":
      return O.get(t)?.name ?? `group ${t}`;
    case "thing":
      return be.get(t)?.name ?? `thing ${t}`;
    case "material":
      return Mt.get(t)?.name ?? `material ${t}`;
    default:
      return `${e} ${t}`;
  }
}
function Qe(e) {
  return e.length === 1 ? ta("lamp", e[0]) : `${e.length} lamps`;
}
function na(e, t) {
  let n = [];
  if (e?.lamp != null) {
    n.push({ kind: "lamp", ids: [e.lamp] });
    let i = w.get(e.lamp)?.group;
    i != null && (O.get(i)?.lamps.length ?? 0) > 1 && n.push({ kind: "group", ids: [i] });
  }
  if (e?.thing != null && n.push({ kind: "thing", ids: [e.thing] }), !n.length) {
    t === "only" && no();
    return;
  }
  if (t !== "only") return _e(n[0].kind, n[0].ids[0], t);
  let o = E.peek(), r = n.findIndex((i) => o?.kind === i.kind && o.ids.length === 1 && o.ids[0] === i.ids[0]);
  E.value = n[(r + 1) % n.length];
}
var oo = g(null);

// src/navigate.ts
var Ws = 1.6, we = g(null), he = G(() => ee.value?.up ?? [0, 0, 1]), ke = g([640, 480]), Nt = g(null), dr = null, mn = null, fr = !1, Je = [], hr = [], mr = 0;
function J(e, t = null) {
  let n = we.peek();
  if (n && dn(n, e)) return;
  let o = performance.now();
  n && (o - mr > 1e3 || t) && (Je.push(n), Je.length > 100 && Je.shift(), hr.length = 0), mr = o, we.value = e, Nt.value = t;
}
var ie = () => we.peek();
function Bs() {
  ra(Je, hr);
}
function zs() {
  ra(hr, Je);
}
function ra(e, t) {
  let n = e.pop();
  if (!n) return;
  let o = we.peek();
  o && t.push(o), mr = performance.now(), we.value = n, Nt.value = null;
}
T(() => {
  !we.value || U.value !== "open" || me.value === "watch" || fr || (fr = !0, requestAnimationFrame(() => {
    fr = !1;
    let t = we.peek();
    if (!t || mn && dn(mn, t)) return;
    let { eye: n, target: o, up: r, fov: i, height: a, near: l } = t, d = { do: "camera", eye: n, target: o, up: r, fov: i };
    a && (d.height = a), l && (d.near = l), F(d) && (mn = t);
  }));
});
T(() => {
  let e = W.value;
  e && se(() => {
    we.peek() && me.peek() === "edit" || (mn = e.camera, we.value = e.camera, dr ??= e.camera);
  });
});
Ce("hello", () => mn = null);
function Ft(e, t) {
  let n = W.peek();
  if (!n) return null;
  let { head: o } = n, r = hn(o.width, o.height);
  return { frame: o.frame, x: (e - r.x) / r.scale, y: (t - r.y) / r.scale };
}
function hn(e, t) {
  let [n, o] = ke.peek(), r = Math.min(n / e, o / t);
  return { x: (n - e * r) / 2, y: (o - t * r) / 2, scale: r };
}
function mt(e = we.peek()) {
  let [t, n] = ke.peek();
  return e ? It(e, t, n) : null;
}
var Dt = () => ee.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]], qt = () => Ge(Dt());
function ro(e, t) {
  let n = ie();
  n && J(qi(n, he.peek(), e, t));
}
function io(e, t, n) {
  let o = ie();
  o && J(Wi(o, he.peek(), e, t, n));
}
function jt(e, t, n) {
  let o = ie(), r = mt();
  o && r && J(Bi(o, r, e, t, n));
}
function ia(e, t, n) {
  let o = ie();
  if (o) {
    if (o.height) {
      let r = mt(o);
      r && J(Xe(o, M(x(r.side, t), x(r.up, e))));
      return;
    }
    ar.peek() === "fly" || n !== 0 ? J(Ui(o, he.peek(), e, t, n)) : (J(ji(o, he.peek(), e, t, 0)), Gs());
  }
}
var Kt = !1, pr = !0, oa = null;
function Gs() {
  let e = ie();
  if (!e || Kt || !pr) return;
  let t = he.peek();
  Kt = !0;
  let n = Ee("ray", { origin: e.eye, direction: x(t, -1) }, (o) => {
    Kt = !1, pr = !0;
    let r = ie();
    if (!o.hit || !r || r.height) return;
    oa = K(o.point, t);
    let i = oa + Ws - K(r.eye, t);
    Math.abs(i) > 0.01 && J(Xe(r, x(t, i * 0.5)));
  }, () => {
    Kt = !1, pr = !1;
  });
  setTimeout(() => {
    Kt && n(), Kt = !1;
  }, 500);
}
function Xs() {
  let e = E.peek();
  if (!e) return null;
  let t = [], n = (i, a) => {
    i ? t.push(i) : a && t.push([a, a]);
  };
  for (let i of e.ids)
    if (e.kind === "lamp" && n(w.get(i)?.box, w.get(i)?.place?.position), e.kind === "thing" && n(be.get(i)?.box), e.kind === "meter" && n(null, Ke.get(i)?.point), e.kind === "group")
      for (let a of O.get(i)?.lamps ?? []) n(w.get(a)?.box, w.get(a)?.place?.position);
  if (!t.length) return null;
  let o = t.flatMap(Vt), r = (i) => [0, 1, 2].map((a) => i(...o.map((l) => l[a])));
  return [r(Math.min), r(Math.max)];
}
function vr() {
  let e = ie(), t = Xs();
  e && t ? J(zi(e, t), "selection") : gr();
}
function gr() {
  dr && J(dr, "home");
}
function Ys(e) {
  let [t, n] = ke.peek();
  J(Xi(e, Dt(), he.peek(), t / n), e);
}
function Qs() {
  for (let e = Je.length - 1; e >= 0; e--)
    if (!Je[e].height) return J(Je[e], "inside");
  gr();
}
var Js = G(() => {
  let e = we.value;
  if (!e?.height) return null;
  let t = It(e, 2, 2), n = Vt(Dt()).map((l) => K(A(l, e.eye), t.forward)), o = e.near ?? 0, r = K(t.forward, he.value), i = Math.min(...Vt(Dt()).map((l) => K(l, he.value))), a = Math.abs(r) > 0.99 ? K(e.eye, he.value) + r * o - i : null;
  return { value: o, most: Math.max(...n), height: a };
});
function Zs(e) {
  let t = ie();
  t && (we.value = { ...t, near: Math.max(0, e) });
}

// src/tools.ts
var ao = g("spot"), vn = null;
function br(e) {
  vn = null, D.value = D.peek() === e ? null : e;
}
function sa(e) {
  if (!e) return Q("There is nothing at that point.", "warn");
  switch (D.peek()) {
    case "aim":
      la(re.peek(), e.point), D.value = null;
      break;
    case "meter":
      ua(e.point, e.normal), D.value = null;
      break;
    case "grid":
      if (!vn) {
        vn = e;
        return;
      }
      el(vn.point, e.point), vn = null, D.value = null;
      break;
    case "add":
      tl(ao.peek(), e), D.value = null;
      break;
  }
}
function la(e, t) {
  let n = {};
  for (let o of e) {
    let r = w.get(o)?.place;
    !r?.position || !r.direction || (n[o] = { place: { aim: t, direction: q(A(t, r.position)) } });
  }
  if (!Object.keys(n).length) return Q("What is selected shines into all directions: it cannot be aimed.", "warn");
  ce(`Aim ${Qe(e)}`, { lamps: n });
}
function yr(e, t) {
  let n = new Set(e.ids.peek()), o = e.ids.subscribe((r) => {
    let i = r.filter((a) => !n.has(a));
    i.length && (_e(t, i[i.length - 1]), queueMicrotask(() => o()));
  });
  setTimeout(() => o(), 3e3);
}
var gn = (e) => Math.max(-1, ...e.ids.peek()) + 1;
function ua(e, t) {
  let n = gn(Ke);
  yr(Ke, "meter"), ce("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function ca(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
function el(e, t, n = { lux: 500, uniformity: 0.6 }) {
  let o = he.peek(), r = Math.abs(o[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], i = q(fe(o, r)), a = A(t, e), [l, d] = [K(a, r), K(a, i)];
  if (Math.abs(l) < 0.05 || Math.abs(d) < 0.05) return Q("An area needs two corners that lie apart.", "warn");
  let u = M(e, M(x(r, Math.min(l, 0)), x(i, Math.min(d, 0))));
  [l, d] = [Math.abs(l), Math.abs(d)];
  let c = (m) => Math.max(1, Math.ceil(m / ca(Math.max(l, d)))), p = gn(at);
  yr(at, "grid"), ce("Lay a grid", {
    grids: {
      [p]: {
        name: `Area ${p + 1}`,
        corner: u,
        u: x(r, l),
        v: x(i, d),
        normal: o,
        columns: c(l),
        rows: c(d),
        target: n
      }
    }
  });
}
var aa = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function tl(e, t) {
  let n = he.peek(), o = K(t.normal, n), r = o > 0.7 ? M(t.point, x(n, 1.2)) : M(t.point, x(t.normal, 0.15)), i = o > 0.7 || o < -0.7 ? x(n, -1) : t.normal, a = { position: r };
  e !== "point" && e !== "sphere" && (a.direction = i), e === "spot" && Object.assign(a, { inner: 24, outer: 36, ...o > 0.7 ? { aim: t.point } : {} }), e === "disc" && (a.radius = 0.15), e === "sphere" && (a.radius = 0.08);
  let l = w.all().filter(([, d]) => d.own).length;
  yr(w, "lamp"), Xn(`Add ${aa[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${aa[e] ?? e} ${l + 1}`, kind: e, flux: 800, place: a }
  });
}
function nl(e, t, n) {
  !e.length || t < 1 || Xn(`Copy ${Qe(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function ol(e) {
  e.length && Xn(`Remove ${Qe(e)}`, { do: "remove", lamps: e });
}
function rl(e, t, n) {
  let o = {};
  for (let r of e) {
    let i = w.get(r)?.place, a = n.get(r);
    if (!a) continue;
    let l = M(a, t), d = i?.aim && Te(i.aim, l) > 1e-6 ? { direction: q(A(i.aim, l)) } : {};
    o[r] = { place: { position: l, ...d } };
  }
  return { lamps: o };
}
function so(e) {
  return e.kind === "sky" || e.kind === "parallel" ? null : e.place?.position ?? (e.box ? Ge(e.box) : null);
}
function il(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let o = w.get(n), r = o && so(o);
    r && t.set(n, r);
  }
  return t;
}

// src/actions.ts
var ht = g(null), Ze = g("lamps"), wr = g("");
function uo(e) {
  let t = Gn();
  t ? Q(t, "warn") : F(e);
}
var al = (e, t) => Object.fromEntries(e.map((n) => [n, t])), sl = {
  quantity: "illuminance",
  low: 1,
  high: 1e3,
  scale: "log",
  palette: "viridis",
  lines: !1
}, _r = sl, ll = () => ut.peek().false_color ?? _r;
function kr() {
  let e = ut.peek().false_color;
  e && (_r = e), Lt({ false_color: e ? null : _r });
}
function co(e) {
  let t = Math.round(((ut.peek().ev ?? 0) + e / 3) * 30) / 30;
  Lt({ ev: t });
}
function ul() {
  let e = ie();
  if (!e) return;
  let t = gn(Ct);
  ce("Store the view", { views: { [t]: { ...e, name: `View ${t + 1}` } } });
}
var cl = () => uo({ do: "look", what: "store", name: `Look ${gn(Et) + 1}` });
async function xr(e) {
  let t = !1;
  try {
    await navigator.clipboard.writeText(e), t = !0;
  } catch {
    let n = document.createElement("textarea");
    n.value = e, n.className = "spoken", document.body.append(n), n.select(), t = document.execCommand("copy"), n.remove();
  }
  Q(t ? "Copied." : `Copy it by hand: ${e}`);
}
var Ut = /* @__PURE__ */ new Map(), lo = null;
function fl(e) {
  Ut = new Map(e.map((t) => [t.id, t])), lo && Z(lo), lo = null;
}
var pl = () => [...Ut.values()], fa = (e) => Ut.get(e), Sr = (e) => Ut.get(e)?.why?.() ?? null;
function Z(e) {
  let t = Ut.get(e);
  Ut.size || (lo = e);
  let n = t?.why?.();
  n ? Q(n, "warn") : t?.run();
}

// src/before.ts
var bn = g(null), ve = g(null), dl = g(0.5);
function ml() {
  let e = W.peek(), t = Ji();
  e && t && (bn.value = { picture: t, camera: e.camera });
}
Fi(() => {
  ve.peek() !== "wipe" && ml();
});
function pa() {
  let e = bn.peek(), t = W.peek();
  if (!e || !t) Q("Nothing has been changed yet.");
  else if (!dn(e.camera, t.camera)) Q("The picture before was taken from another place: go back there with Alt+←.", "warn");
  else return !0;
  return !1;
}
function yn(e) {
  e ? ve.peek() === null && pa() && (ve.value = "held") : ve.peek() === "held" && (ve.value = null);
}
function hl() {
  ve.value = ve.peek() === "wipe" ? null : pa() ? "wipe" : null;
}

// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var vl = /* @__PURE__ */ Symbol.for("pv"), gl = 0;
function s(e, t, n, o, r, i) {
  t || (t = {});
  var a, l, d = t;
  if ("ref" in d && typeof e != "function") for (l in d = {}, t) l == "ref" ? a = t[l] : d[l] = t[l];
  var u = { type: e, props: d, key: n, ref: a, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: vl, __v: --gl, __i: -1, __u: 0 };
  return (r || i) && (u.__source = r, u.__self = i), C.vnode && C.vnode(u), u;
}

// src/load.tsx
var ma = g(null), da = !1;
function ae({ part: e }) {
  let t = ma.value?.[e];
  return t ? s(t, {}) : null;
}
function ha() {
  T(() => {
    if (da || !(W.value ?? E.value)) return;
    da = !0;
    let e = "./gizmo.js";
    setTimeout(() => {
      import(e).then((t) => ma.value = t);
    }, 0);
  });
}

// src/units.ts
var fo = 0.3048, va = {
  level: { bare: 0.01, units: { "%": 0.01, x: 1, "×": 1 }, low: 0, high: 1e3, say: "a level such as 80 % or 450 lm" },
  flux: { bare: 1, units: { lm: 1, klm: 1e3 }, low: 0, high: 1e9, say: "a flux such as 450 lm" },
  kelvin: { bare: 1, units: { k: 1 }, low: 1e3, high: 25e3, say: "a colour temperature such as 2700 K" },
  angle: { bare: 1, units: { "°": 1, deg: 1, rad: 180 / Math.PI }, low: -36e3, high: 36e3, say: "an angle such as 30°" },
  length: {
    bare: 1,
    units: { m: 1, cm: 0.01, mm: 1e-3, km: 1e3, ft: fo, "'": fo, in: fo / 12, '"': fo / 12 },
    low: -1e6,
    high: 1e6,
    say: `a length such as 2.4 m, 75 cm or 8'2"`
  },
  lux: { bare: 1, units: { lx: 1, klx: 1e3, fc: 10.7639 }, low: 0, high: 1e9, say: "an illuminance such as 500 lx" },
  share: { bare: 1, units: { "%": 0.01 }, low: 0, high: 1, say: "a share from 0 to 1 or 0 to 100 %" },
  number: { bare: 1, units: {}, low: -1e9, high: 1e9, say: "a number" },
  ev: { bare: 1, units: { ev: 1, stop: 1, stops: 1 }, low: -30, high: 30, say: "an exposure such as 8.3" },
  seconds: { bare: 1, units: { s: 1, ms: 1e-3, min: 60 }, low: 0, high: 3600, say: "a time such as 2 s" }
}, bl = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;
function Mr(e) {
  let t = bl.exec(e);
  if (!t) return null;
  let [n, o] = t[0].split("/").map(Number);
  return o === 0 ? null : { value: o === void 0 ? n : n / o, rest: e.slice(t[0].length).trimStart() };
}
function ga(e, t, n) {
  let o = e.trim(), r = 0, i = !0;
  for (; o; ) {
    let a = 1, l = /^[+-]\s*/.exec(o);
    l && !i && (a = o[0] === "-" ? -1 : 1, o = o.slice(l[0].length));
    let d = Mr(o);
    if (!d) return null;
    let u = /^[a-zµ°%'"×]+/i.exec(d.rest)?.[0] ?? "", c = u === "" ? n : t.units[u.toLowerCase()];
    if (c === void 0) return null;
    r += a * d.value * c, o = d.rest.slice(u.length).trim(), i = !1;
  }
  return i ? null : r;
}
function ba(e, t, n) {
  let o = va[t], r = e.trim().replace(/,(?=\d)/g, ".").replace(/[\u2009\u202f\u00a0]/g, "").replace(/−/g, "-"), i = { why: `“${e.trim()}” is not ${o.say}` }, a = (k) => ({
    apply: (S) => Math.min(o.high, Math.max(o.low, k(S)))
  });
  if (!r) return { why: `Type ${o.say}` };
  let l = r.toLowerCase();
  if (t === "level" && l === "full") return a(() => 1);
  if (t === "level" && (l === "out" || l === "off")) return a(() => 0);
  let d = /^(.*?)\s*(?:stops?|ev)$/i.exec(r);
  if (d && t !== "ev") {
    let k = Mr(d[1].trim());
    return !k || k.rest || !["level", "flux", "lux", "number"].includes(t) ? i : a((S) => S * 2 ** k.value);
  }
  let u = /^([*/×÷])\s*(.+)$/.exec(r);
  if (u) {
    let k = Mr(u[2]);
    if (!k) return i;
    let S = k.rest === "%" ? 0.01 : k.rest === "" ? 1 : NaN, y = k.value * S;
    return !Number.isFinite(y) || y === 0 && /[/÷]/.test(u[1]) ? i : a((b) => /[/÷]/.test(u[1]) ? b / y : b * y);
  }
  let p = t === "length" || t === "angle" || t === "ev" || t === "number" ? /^([+-])=\s*(.+)$/.exec(r) : /^([+-])=?\s*(.+)$/.exec(r), m = p ? p[2] : r, f = ga(m, o, o.bare);
  if (f === null && t === "level" && n) {
    let k = ga(m, { ...va.flux }, NaN);
    f = k === null || Number.isNaN(k) ? null : k / n;
  }
  if (f === null || !Number.isFinite(f)) return i;
  let _ = f;
  return p ? a((k) => p[1] === "-" ? k - _ : k + _) : _ < o.low || _ > o.high ? { why: `${e.trim()} is out of range: ${o.say}` } : a(() => _);
}
function B(e, t = 0) {
  if (!Number.isFinite(e)) return "–";
  let [n, o] = Math.abs(e).toFixed(t).split("."), r = n.length > 4 ? n.replace(/\B(?=(\d{3})+$)/g, " ") : n;
  return (e < 0 && Number(Math.abs(e).toFixed(t)) !== 0 ? "−" : "") + r + (o ? `.${o}` : "");
}
function Re(e) {
  let t = Math.abs(e);
  return B(e, t >= 99.95 || t === 0 ? 0 : t >= 9.995 ? 1 : t >= 0.9995 ? 2 : 3);
}
function He(e) {
  let t = e * 100;
  return B(t, t >= 9.95 || t === 0 ? 0 : t >= 0.95 ? 1 : 2);
}
function _n(e, t) {
  switch (t) {
    case "level":
      return `${He(e)} %`;
    case "flux":
      return `${Re(e)} lm`;
    case "kelvin":
      return `${B(e)} K`;
    case "angle":
      return `${B(e, 1)}°`;
    case "length":
      return `${B(e, 2)} m`;
    case "lux":
      return `${Re(e)} lx`;
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
function vt(e, t = !0) {
  let n = Ot.value === "fc", o = n ? e / 10.7639 : e;
  return Re(o) + (t ? n ? " fc" : " lx" : "");
}

// src/field.tsx
function gt(e) {
  let t = it(null), n = it(null), o = oe(null), r = oe(null), i = t.value ?? e.text ?? (e.value === null ? "mixed" : _n(e.value, e.quantity));
  $e(() => {
    !e.open || !o.current || (t.value = e.open, o.current.focus(), o.current.setSelectionRange(e.open.length, e.open.length), e.opened?.());
  }, [e.open]);
  let a = () => {
    if (t.value === null) return;
    let p = ba(t.value, e.quantity, e.flux);
    if ("why" in p) {
      n.value = p.why;
      return;
    }
    t.value = null, n.value = null, e.set(p.apply);
  }, l = (p) => {
    if (p.key === "Enter")
      p.preventDefault(), a(), t.value === null && o.current?.select();
    else if (p.key === "Escape")
      p.stopPropagation(), t.value === null && o.current?.blur(), t.value = null, n.value = null;
    else if ((p.key === "ArrowUp" || p.key === "ArrowDown") && e.step && t.value === null) {
      p.preventDefault();
      let m = (p.key === "ArrowUp" ? 1 : -1) * e.step * (p.shiftKey ? 10 : p.ctrlKey ? 0.1 : 1);
      e.set((f) => f + m);
    }
  }, d = (p) => {
    !e.scrub || e.disabled || p.button !== 0 || document.activeElement === o.current || (r.current = { x: p.clientX, last: p.clientX, moved: !1 }, o.current?.setPointerCapture(p.pointerId), p.preventDefault());
  }, u = (p) => {
    let m = r.current;
    !m || !e.scrub || !m.moved && Math.abs(p.clientX - m.x) < 4 || (m.moved || e.scrub.begin(), m.moved = !0, e.scrub.on((p.clientX - m.last) * (e.step ?? 1) * (p.shiftKey ? 0.1 : p.altKey ? 10 : 1)), m.last = p.clientX);
  }, c = (p) => {
    let m = r.current;
    r.current = null, m && (m.moved ? p.type === "pointercancel" ? e.scrub?.cancel() : e.scrub?.end() : (o.current?.focus(), o.current?.select()));
  };
  return s("span", { class: `field ${n.value ? "wrong" : ""} ${e.scrub ? "scrubs" : ""}`, children: [
    s(
      "input",
      {
        ref: o,
        id: e.id,
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
        onInput: (p) => {
          t.value = p.currentTarget.value, n.value = null;
        },
        onFocus: (p) => t.value === null && p.currentTarget.select(),
        onBlur: () => {
          a(), n.value && (t.value = null, setTimeout(() => n.value = null, 4e3));
        },
        onKeyDown: l,
        onPointerDown: d,
        onPointerMove: u,
        onPointerUp: c,
        onPointerCancel: c
      }
    ),
    n.value && s("span", { class: "why", role: "alert", id: `${e.id ?? e.label}-why`.replace(/\s/g, "-"), children: n.value })
  ] });
}

// src/icon.tsx
function j({ name: e }) {
  return s("svg", { class: "sign", "aria-hidden": "true", width: "16", height: "16", children: s("use", { href: `icons.svg#${e}` }) });
}

// src/menu.tsx
function Wt({ id: e, label: t, title: n, children: o }) {
  let r = (a) => {
    let l = document.getElementById(e), d = a.getBoundingClientRect();
    l?.style.setProperty("left", `${Math.max(8, Math.min(d.left, innerWidth - 296))}px`), l?.style.setProperty("top", `${d.bottom + 4}px`);
  };
  return s(X, { children: [
    s("button", { ...{ popovertarget: e }, title: n, "aria-label": n, "aria-haspopup": "true", onPointerDown: (a) => r(a.currentTarget), onFocus: (a) => r(a.currentTarget), children: t }),
    s("div", { id: e, popover: "auto", class: "menu", children: o })
  ] });
}
function Cr({ id: e, label: t }) {
  let n = Sr(e), o = fa(e);
  return s(
    "button",
    {
      class: "item",
      "aria-disabled": n !== null,
      title: n ?? void 0,
      onClick: (r) => {
        r.currentTarget.closest("[popover]")?.hidePopover(), Z(e);
      },
      children: [
        s("span", { children: t ?? o?.label }),
        s("kbd", { children: o?.keys })
      ]
    }
  );
}

// src/bar.tsx
var ya = {
  clean: "nothing changed",
  saved: "saved",
  waiting: "saving…",
  failed: "not saved"
};
function _a() {
  let e = ut.value, t = st.value.undo, n = st.value.redo, o = lt.value, r = e.metered;
  return s("header", { class: "bar", children: [
    s(Wt, { id: "page-menu", label: s(j, { name: "menu" }), title: "Page", children: s(ae, { part: "PageItems" }) }),
    s("h1", { title: o.file || ee.value?.file, children: [
      ee.value?.name ?? "Lampyris",
      s("i", { class: `dot ${o.state}`, role: "img", "aria-label": ya[o.state], title: `${ya[o.state]}${o.file ? `: ${o.file}` : ""}` })
    ] }),
    s("span", { class: "group", children: [
      s("button", { class: "icon", "aria-label": t ? `Undo: ${t}` : "Undo", title: t ? `Undo: ${t} (Ctrl+Z)` : "Nothing to undo", "aria-disabled": t === null, onClick: () => Z("undo"), children: s(j, { name: "undo" }) }),
      s("button", { class: "icon", "aria-label": n ? `Redo: ${n}` : "Redo", title: n ? `Redo: ${n} (Ctrl+Shift+Z)` : "Nothing to redo", "aria-disabled": n === null, onClick: () => Z("redo"), children: s(j, { name: "redo" }) })
    ] }),
    s(Wt, { id: "view-menu", label: s(X, { children: [
      "View ",
      s(j, { name: "down" })
    ] }), title: "View", children: s(ae, { part: "ViewItems" }) }),
    s("span", { class: "group wide", children: [
      s("button", { "aria-pressed": !1, onClick: () => Z("preset-plan"), title: "Plan (Shift+1)", children: "Plan" }),
      s("button", { onClick: () => Z("inside"), title: "Inside (Shift+0)", children: "Inside" })
    ] }),
    s("span", { class: "gap" }),
    s(Wt, { id: "seeing-menu", label: s(X, { children: [
      "Picture ",
      s(j, { name: "down" })
    ] }), title: "Picture: tone, white, figures", children: s(ae, { part: "SeeingItems" }) }),
    s("button", { "aria-pressed": e.false_color !== null, onClick: kr, title: "False colour (B)", children: "False colour" }),
    s("button", { "aria-pressed": ve.value === "wipe", "aria-disabled": bn.value === null, onClick: () => Z("wipe"), title: "Wipe between before and now (C); hold \\ to see before", children: "Compare" }),
    s("span", { class: "group exposure", role: "group", "aria-label": "Exposure", children: [
      s("button", { class: "icon", "aria-label": "Darker", title: "Darker by ⅓ (,)", onClick: () => co(1), children: s(j, { name: "minus" }) }),
      s("label", { children: [
        s("span", { "aria-hidden": "true", children: "EV" }),
        s(gt, { label: "Exposure value", quantity: "ev", value: e.ev ?? 0, step: 1 / 3, set: (i) => Lt({ ev: i(e.ev ?? 0) }) })
      ] }),
      s("button", { class: "icon", "aria-label": "Brighter", title: "Brighter by ⅓ (.)", onClick: () => co(-1), children: s(j, { name: "plus" }) }),
      s("button", { class: "icon", "aria-label": "Meter once", title: `${r ? "As metered" : "Meter once"} (/); it stays locked`, onClick: () => F({ do: "expose" }), children: s(j, { name: r ? "lock" : "meter" }) })
    ] }),
    s(
      "button",
      {
        class: "icon look-lock",
        "aria-pressed": Ae.value,
        "aria-label": "Look-only lock",
        title: "Look-only lock: no finger changes anything",
        onClick: () => Ae.value = !Ae.value,
        children: s(j, { name: Ae.value ? "lock" : "unlock" })
      }
    ),
    me.value === "edit" && s("button", { class: "wide", onClick: () => ht.value = "share", children: "Share" }),
    s("button", { class: "icon", "aria-label": "All keys", title: "All keys (?)", onClick: () => ht.value = "help", children: s(j, { name: "help" }) }),
    s("button", { class: "icon", "aria-label": "Command palette", title: "Command palette (Ctrl+K)", onClick: () => ht.value = "palette", children: s(j, { name: "search" }) }),
    s(
      "button",
      {
        class: "icon narrow",
        "aria-label": Ze.value === "inspector" ? "Lamps" : "Inspector",
        title: Ze.value === "inspector" ? "Lamps" : "Inspector",
        onClick: () => Ze.value = Ze.value === "inspector" ? "lamps" : "inspector",
        children: s(j, { name: Ze.value === "inspector" ? "lamps" : "sliders" })
      }
    )
  ] });
}

// src/highlight.ts
function po(e) {
  Me.value = e, F({ do: "solo", lamps: e });
}
function Er(e) {
  let t = Me.peek(), n = e.every((o) => t.includes(o));
  po(n ? t.filter((o) => !e.includes(o)) : [...t, ...e.filter((o) => !t.includes(o))]);
}
var yl = () => Er(re.peek()), Tr = () => po([]), wn = null;
function mo(e) {
  e && wn === null && re.peek().length ? (wn = Me.peek(), po(re.peek())) : !e && wn !== null && (po(wn), wn = null);
}

// src/lights.ts
var et = g(null), $r = () => {
}, ka = () => {
};
function ho(e, t, n) {
  vo(), et.value = { x: e, y: t, hit: n, lux: n.lux, lamps: [], done: !1 }, wa(n);
  let o = !0, r = 0;
  ka = T(() => {
    for (let [, i] of w.all()) ye(i);
    if (o) {
      o = !1;
      return;
    }
    clearTimeout(r), r = window.setTimeout(() => {
      let i = se(() => et.value);
      i && wa(i.hit);
    }, 250);
  });
}
function wa(e) {
  $r(), $r = Ee("light", { point: e.point, normal: e.normal }, (t) => {
    let n = et.peek();
    n && (et.value = {
      ...n,
      lux: t.lux ?? n.lux,
      lamps: t.lamps ?? n.lamps,
      done: t.done !== !1
    });
  });
}
function vo() {
  $r(), ka(), et.value = null;
}

// src/keys.ts
var $a = g("W A S D"), Pr = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyA: [0, -1, 0],
  KeyD: [0, 1, 0],
  KeyQ: [0, 0, -1],
  KeyE: [0, 0, 1]
}, _l = 1.8, Bt = /* @__PURE__ */ new Set(), go = !1, bo = 1, Lr = !1, Vr = 0;
function Pa(e) {
  let t = Math.min(0.1, Math.max(0, (e - Vr) / 1e3));
  if (Vr = e, !Bt.size) {
    Lr = !1;
    return;
  }
  let [n, o, r] = [0, 0, 0];
  for (let l of Bt) {
    let [d, u, c] = Pr[l];
    n += d, o += u, r += c;
  }
  let i = Math.max(1, Te(...Dt()) / 12), a = _l * t * bo * Math.min(i, 6);
  (n || o || r) && ia(n * a, o * a, r * a), requestAnimationFrame(Pa);
}
function kn(e) {
  Bt.add(e), !Lr && (Lr = !0, Vr = performance.now(), requestAnimationFrame(Pa));
}
var wl = (e) => e instanceof HTMLElement && (e.isContentEditable || e.matches("input, textarea, select") && !e.matches("[type=range], [type=checkbox], [type=radio]"));
function xa() {
  let e = document.activeElement;
  return e === null || e === document.body || e.id === "view";
}
var kl = {
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
}, Sa = {
  b: "quantity",
  o: "park",
  i: "unsolo",
  l: "from-lamp",
  g: "grid",
  t: "aim-here"
}, Ma = { Comma: "darker", Period: "brighter", Slash: "expose" }, Ca = {
  Digit1: "preset-plan",
  Digit2: "preset-ceiling",
  Digit3: "preset-north",
  Digit4: "preset-east",
  Digit5: "preset-south",
  Digit6: "preset-west",
  Digit0: "inside"
};
function xl(e) {
  let t = e.key.toLowerCase();
  return t === "z" ? e.shiftKey ? "redo" : "undo" : t === "y" ? "redo" : t === "k" ? "palette" : t === "s" ? e.shiftKey ? "picture" : "save" : t === "d" ? "duplicate" : t === "a" ? "all-lamps" : t === "enter" ? "look-store" : null;
}
function Sl() {
  D.peek() ? D.value = null : et.peek() ? vo() : ve.peek() ? ve.value = null : E.peek() ? no() : document.activeElement?.id === "view" && document.querySelector('.bar button, .bar [tabindex="0"]')?.focus();
}
function Ea(e) {
  let [t, n] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
  return !t && !n ? !1 : (e.ctrlKey || ie()?.height ? jt(-t * 24, n * 24, 3) : e.shiftKey ? io(qt(), -t * 0.05, n * 0.05) : ro(-t * 0.06, n * 0.06), !0);
}
function Ta(e) {
  let t = ie(), n = mt();
  !t || !n || (t.height ? J(Jn(t, n, n.width / 2, n.height / 2, e)) : J(Qn(t, t.target, e, 0.3, !0)));
}
function Ml(e) {
  if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
  let t = e.ctrlKey || e.metaKey;
  if (e.key === "Escape") return Sl();
  if (wl(e.target)) {
    t && e.key.toLowerCase() === "k" && qe(e, "palette");
    return;
  }
  if (t && !e.altKey) {
    if (xa() && Ea(e)) return e.preventDefault();
    let i = xl(e);
    i && qe(e, i);
    return;
  }
  if (e.altKey) {
    let i = /^Digit(\d)$/.exec(e.code)?.[1];
    if (e.key === "ArrowLeft") return qe(e, "back");
    if (e.key === "ArrowRight") return qe(e, "forth");
    if (i === "0") return qe(e, "store-view");
    if (i) {
      e.preventDefault();
      let a = Ct.all()[Number(i) - 1];
      a && J(a[1], a[1].name ?? "view");
      return;
    }
    if (e.code === "KeyH" && qe(e, "unhide"), !(e.code in Pr)) return;
  }
  let n = xa();
  if (n && Ea(e)) return e.preventDefault();
  if (n && e.code in Pr)
    return bo = e.shiftKey ? 4 : e.altKey ? 0.25 : 1, kn(e.code), e.preventDefault();
  if (n && (e.key === "+" || e.key === "=")) return Ta(0.85);
  if (n && (e.key === "-" || e.key === "_")) return Ta(1 / 0.85);
  if (!lr.peek()) return;
  if (e.shiftKey && Ca[e.code]) return qe(e, Ca[e.code]);
  if (go && /^\d$/.test(e.key)) {
    e.preventDefault(), go = !1;
    let i = Et.ids.peek()[Number(e.key) - 1];
    i !== void 0 && uo({ do: "look", id: i, what: "recall", seconds: cr.peek() });
    return;
  }
  if (go = e.key.toLowerCase() === "j", go) return Q("Recall a look: now its digit.");
  if (!e.shiftKey && /^\d$/.test(e.key) && re.peek().length) {
    e.preventDefault(), wr.value = e.key;
    return;
  }
  if (!e.shiftKey && e.key !== "?" && Ma[e.code]) return qe(e, Ma[e.code]);
  if (e.key === "\\") return void (e.repeat || yn(!0));
  let o = e.key.toLowerCase();
  if (o === "l" && !e.shiftKey) return void (e.repeat || Z("highlight"));
  if (o === "p" && e.shiftKey) return Cl();
  let r = e.shiftKey && Sa[o] ? Sa[o] : kl[o];
  r && !(e.target instanceof HTMLButtonElement && o === "enter") && qe(e, r);
}
function Cl() {
  let [e, t] = ke.peek(), n = Ft(e / 2, t / 2);
  n && Ee("point", n, (o) => o.hit && ho(e / 2, t / 2, o));
}
function qe(e, t) {
  e.preventDefault(), Z(t);
}
function El(e) {
  Bt.delete(e.code), e.key === "\\" && yn(!1), e.key.toLowerCase() === "l" && mo(!1), e.key === "Shift" && (bo = 1);
}
function La() {
  addEventListener("keydown", Ml), addEventListener("keyup", El), addEventListener("blur", () => {
    Bt.clear(), mo(!1), yn(!1);
  }), navigator.keyboard?.getLayoutMap().then((t) => {
    $a.value = ["KeyW", "KeyA", "KeyS", "KeyD"].map((n) => (t.get(n) ?? n.slice(3)).toUpperCase()).join(" ");
  }).catch(() => {
  });
}
function Tl(e, t) {
  for (let n of ["KeyW", "KeyS", "KeyA", "KeyD"]) Bt.delete(n);
  bo = Math.min(1, Math.hypot(e, t)), e > 0.2 && kn("KeyW"), e < -0.2 && kn("KeyS"), t < -0.2 && kn("KeyA"), t > 0.2 && kn("KeyD");
}

// src/levels.ts
var Ir = (e) => Math.min(1, to.value === "square" ? Math.sqrt(Math.max(e, 0)) : e), Ar = (e) => {
  let t = to.peek() === "square" ? e * e : e;
  return Math.round(t * 1e3) / 1e3;
}, $l = (e) => (e.kind === "lamp" ? w.get(e.id) : O.get(e.id))?.level ?? 0, yo = (e) => (e.kind === "lamp" ? w.get(e.id) : O.get(e.id))?.name ?? "";
function Rr(e) {
  let t = re.peek();
  return e.kind === "lamp" && E.peek()?.kind === "lamp" && t.length > 1 && t.includes(e.id) ? t : [e.id];
}
function Va(e, t, n) {
  if (e.kind === "group") return { groups: { [e.id]: { level: t } } };
  let o = n.get(e.id) ?? 0, r = {};
  for (let [i, a] of n) {
    let l = i === e.id ? t : o > 0 ? Math.min(10, a * (t / o)) : t;
    r[i] = { level: Math.round(l * 1e3) / 1e3 };
  }
  return { lamps: r };
}
var xn = class {
  constructor(t) {
    this.strip = t;
    this.was = this.now = $l(t), this.from = t.kind === "lamp" ? new Map(Rr(t).map((n) => [n, w.get(n)?.level ?? 0])) : /* @__PURE__ */ new Map(), this.gesture = new Ne(`${yo(t)} level`);
  }
  strip;
  gesture;
  from;
  was;
  now;
  to(t) {
    this.now = t, this.gesture.set(Va(this.strip, t, this.from));
  }
  end() {
    let t = this.from.size > 1 ? Qe([...this.from.keys()]) : yo(this.strip);
    this.gesture.end(`${t} ${He(this.was)} → ${He(this.now)} %`);
  }
  cancel() {
    this.gesture.cancel();
  }
};
function _o(e, t) {
  let n = new Map(Rr(e).map((o) => [o, w.get(o)?.level ?? 0]));
  Zo(`level ${e.kind} ${e.id}`, `${yo(e)} level`, Va(e, t, n));
}
function Sn(e, t) {
  if (!e.length) return;
  let n = Object.fromEntries(e.map((r) => {
    let i = w.get(r);
    return [r, { level: t(i?.level ?? 0, i?.flux ?? 1) }];
  })), o = e.length === 1 ? ` ${He(w.get(e[0])?.level ?? 0)} → ${He(n[e[0]].level)} %` : " level";
  ce(`${Qe(e)}${o}`, { lamps: n });
}
function wo(e, t) {
  let n = t(O.get(e)?.level ?? 0);
  ce(`${O.get(e)?.name ?? "Group"} ${He(n)} %`, { groups: { [e]: { level: n } } });
}
function ko(e, t) {
  let n = `${yo(e)} ${t ? "on" : "off"}`;
  e.kind === "group" ? ce(n, { groups: { [e.id]: { on: t } } }) : ce(n, { lamps: Object.fromEntries(Rr(e).map((o) => [o, { on: t }])) });
}

// src/swatch.ts
var Pl = (e) => e <= 31308e-7 ? 12.92 * e : 1.055 * e ** 0.4166666666666667 - 0.055, Ll = (e) => e <= 0.04045 ? e / 12.92 : ((e + 0.055) / 1.055) ** 2.4, Vl = (e) => Math.round(255 * Pl(Math.max(0, Math.min(1, e))));
function Mn(e) {
  let t = Math.max(...e, 1e-6);
  return Ia(e.map((n) => n / t));
}
function Ia(e) {
  return `#${e.map((t) => Vl(t).toString(16).padStart(2, "0")).join("")}`;
}
function Il(e) {
  let t = (n) => Ll(parseInt(e.slice(1 + 2 * n, 3 + 2 * n), 16) / 255);
  return [t(0), t(1), t(2)];
}
var Al = (e) => 1e6 / e;

// src/range.tsx
var Aa = -1e9;
addEventListener("scroll", () => Aa = performance.now(), { capture: !0, passive: !0 });
var zt = (e) => Math.max(0, Math.min(1, e));
function Hr(e) {
  let t = oe(null), n = oe(null), o = e.notch ?? 0.01, r = (u) => {
    if (u.button !== 0 || e.disabled) return;
    let c = u.currentTarget.getBoundingClientRect(), p = e.vertical ? (c.bottom - u.clientY - 8) / (c.height - 16) : (u.clientX - c.left - 6) / (c.width - 12), m = u.pointerType !== "touch" && !u.shiftKey;
    n.current = { id: u.pointerId, x: u.clientX, y: u.clientY, at: m ? zt(p) : e.value }, t.current?.setPointerCapture(u.pointerId), t.current?.focus(), e.begin?.(), m && e.on(zt(p));
  }, i = (u) => {
    let c = n.current;
    if (!c || c.id !== u.pointerId) return;
    let p = u.currentTarget.getBoundingClientRect(), m = e.vertical ? (c.y - u.clientY) / (p.height - 16) : (u.clientX - c.x) / (p.width - 12);
    c.x = u.clientX, c.y = u.clientY, c.at += m * (u.shiftKey ? 0.1 : 1), e.on(zt(c.at));
  }, a = (u) => {
    n.current?.id === u.pointerId && (n.current = null, u.type === "pointercancel" ? e.cancel?.() : e.end?.());
  }, l = (u) => {
    if (u.key === "Escape" && n.current) {
      n.current = null, e.cancel?.(), u.stopPropagation();
      return;
    }
    let c = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[u.key], p = null;
    c && (p = zt(e.value + c * o * (u.shiftKey ? 10 : 1))), u.key === "Home" && (p = 0), u.key === "End" && (p = 1), !(p === null || u.altKey || u.ctrlKey || u.metaKey) && (u.preventDefault(), u.stopPropagation(), e.on(p));
  }, d = (u) => {
    if (performance.now() - Aa < 400 || u.ctrlKey) return;
    u.preventDefault();
    let c = Math.abs(u.deltaY) >= Math.abs(u.deltaX) ? u.deltaY : u.deltaX;
    c && e.on(zt(e.value - Math.sign(c) * o * (u.shiftKey ? 0.2 : 1)));
  };
  return s(
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
      style: { "--t": zt(e.value), "--gradient": e.gradient ?? "" },
      onPointerDown: r,
      onPointerMove: i,
      onPointerUp: a,
      onPointerCancel: a,
      onMouseDown: (u) => u.preventDefault(),
      onTouchStart: (u) => u.cancelable && u.preventDefault(),
      onKeyDown: l,
      onWheel: d,
      onDblClick: () => e.reset?.(),
      onInput: (u) => {
        n.current ? u.currentTarget.value = String(e.value) : e.on(Number(u.currentTarget.value));
      }
    }
  );
}

// src/faderrow.tsx
function So(e) {
  let t = e.color;
  return t.mode === "kelvin" ? `${B(t.kelvin)} K` : t.mode === "rgb" ? "RGB" : t.mode === "xy" ? "x y" : "file";
}
var xo = (e) => e.free ? "re-mix: level and colour cost no ray" : "re-trace: its light is traced anew";
function Ra({ row: e, index: t, count: n }) {
  let o = oe(null), r = { kind: e.kind, id: e.id }, i = e.kind === "lamp" ? w.get(e.id) : void 0, a = e.kind === "group" ? O.get(e.id) : void 0, l = i ?? a;
  if (!l) return null;
  let d = a?.lamps ?? [e.id], u = i ? i.flux : d.reduce((y, b) => y + (w.get(b)?.flux ?? 0) * (w.get(b)?.level ?? 0), 0), c = i ? i.flux * ye(i) : d.reduce((y, b) => y + (w.get(b)?.flux ?? 0) * ye(w.get(b)), 0), p = E.value?.kind === e.kind && E.value.ids.includes(e.id), m = d.length > 0 && d.every((y) => Me.value.includes(y)), f = Me.value.length > 0 && !d.some((y) => Me.value.includes(y)), _ = ne.value?.kind === e.kind && ne.value.id === e.id, k = `${p ? "selected" : ""} ${l.on && !i?.parked ? "" : "off"} ${f ? "muted" : ""} ${_ ? "under" : ""}`, S = {
    begin: () => o.current = new xn(r),
    end: () => {
      o.current?.end(), o.current = null;
    },
    cancel: () => {
      o.current?.cancel(), o.current = null;
    }
  };
  return s(
    "div",
    {
      class: `fader-row depth-${e.depth} ${e.kind} ${k}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => ne.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => ne.value = null,
      children: [
        s("button", { class: "icon power", "aria-pressed": l.on, "aria-label": `${l.name} on`, title: l.on ? "On (O)" : "Off (O)", onClick: () => ko(r, !l.on), children: s(j, { name: "power" }) }),
        s("div", { class: "top", children: [
          a && s("button", { class: "icon fold", "aria-expanded": !bt.value.has(e.id), "aria-label": `Members of ${l.name}`, onClick: () => Ha(e.id), children: s(j, { name: bt.value.has(e.id) ? "right" : "down" }) }),
          s("button", { class: "row-name", "aria-pressed": p, title: i ? `${i.name}: ${xo(i)}` : l.name, onClick: (y) => Mo(y, e.kind, e.id), children: [
            s("span", { children: l.name }),
            a && s("small", { children: d.length }),
            i?.parked && s("small", { children: "parked" }),
            i && !i.free && s("small", { class: "traced", title: xo(i), children: [
              "↻",
              s("span", { class: "spoken", children: "re-trace" })
            ] })
          ] }),
          i && s("span", { class: "tint", children: [
            s("i", { class: "swatch", style: { background: Mn(i.swatch) } }),
            So(i)
          ] }),
          s("button", { class: "icon solo", "aria-pressed": m, "aria-label": `Solo ${l.name}`, title: "Solo (I)", onClick: () => Er(d), children: s(j, { name: "solo" }) })
        ] }),
        s("div", { class: "bottom", children: [
          s(
            Hr,
            {
              label: `${l.name} level`,
              class: "level",
              value: Ir(l.level),
              text: `${He(l.level)} %, ${Re(c)} lumen`,
              notch: 0.01,
              on: (y) => {
                let b = Ar(y);
                o.current ? o.current.to(b) : _o(r, b);
              },
              reset: () => _o(r, 1),
              ...S
            }
          ),
          s(
            gt,
            {
              label: `${l.name} level, typed`,
              quantity: "level",
              value: l.level,
              flux: u,
              step: 0.01,
              set: (y) => i ? Sn(p && re.peek().length > 1 ? re.peek() : [e.id], y) : wo(e.id, y)
            }
          ),
          s("span", { class: "lumens", children: _n(c, "flux") })
        ] })
      ]
    }
  );
}

// src/sheetrow.tsx
function Oa() {
  return s("div", { class: "sheet-row head", "aria-hidden": "true", children: [
    s("span", {}),
    s("span", { children: "Name" }),
    s("span", { children: "Level" }),
    s("span", { children: "lm" }),
    s("span", { children: "White" })
  ] });
}
function Ka({ row: e, index: t, count: n }) {
  let o = e.kind === "lamp" ? w.get(e.id) : void 0, r = e.kind === "group" ? O.get(e.id) : void 0, i = o ?? r;
  if (!i) return null;
  let a = E.value?.kind === e.kind && E.value.ids.includes(e.id), l = o ? o.flux * ye(o) : (r?.lamps ?? []).reduce((u, c) => {
    let p = w.get(c);
    return u + (p ? p.flux * ye(p) : 0);
  }, 0), d = ne.value?.kind === e.kind && ne.value.id === e.id;
  return s(
    "div",
    {
      class: `sheet-row depth-${e.depth} ${e.kind} ${a ? "selected" : ""} ${i.on ? "" : "off"} ${d ? "under" : ""}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => ne.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => ne.value = null,
      children: [
        s("button", { class: "icon power", "aria-pressed": i.on, "aria-label": `${i.name} on`, onClick: () => ko(e, !i.on), children: s(j, { name: "power" }) }),
        s("button", { class: "row-name", "aria-pressed": a, title: o ? xo(o) : void 0, onClick: (u) => Mo(u, e.kind, e.id), onDblClick: () => Z("frame"), children: s("span", { children: i.name }) }),
        s(
          gt,
          {
            label: `${i.name} level`,
            quantity: "level",
            value: i.level,
            flux: o?.flux,
            step: 0.01,
            set: (u) => o ? Sn([e.id], u) : wo(e.id, u)
          }
        ),
        s("span", { class: "lumens", children: Re(l) }),
        o ? s("button", { class: "tint", "aria-label": `${i.name} colour: ${So(o)}`, onClick: () => _e("lamp", e.id), children: [
          s("i", { class: "swatch", style: { background: Mn(o.swatch) } }),
          So(o)
        ] }) : s("span", {})
      ]
    }
  );
}

// src/virtual.tsx
var Da = 4;
function Or({ count: e, height: t, row: n, label: o, show: r, role: i = "list" }) {
  let a = oe(null), l = it(0), d = it(600);
  $e(() => {
    let p = a.current, m = new ResizeObserver(() => d.value = p.clientHeight);
    return m.observe(p), () => m.disconnect();
  }, []), $e(() => {
    let p = a.current;
    if (!p || r === void 0 || r < 0) return;
    let m = r * t;
    (m < p.scrollTop || m + t > p.scrollTop + p.clientHeight) && (p.scrollTop = Math.max(0, m - p.clientHeight / 2));
  }, [r, t]);
  let u = Math.max(0, Math.floor(l.value / t) - Da), c = Math.min(e, Math.ceil((l.value + d.value) / t) + Da);
  return s("div", { class: "virtual", ref: a, tabIndex: e ? void 0 : -1, onScroll: (p) => l.value = p.currentTarget.scrollTop, children: s("div", { class: "all", role: i, "aria-label": o, style: { height: `${e * t}px` }, children: s("div", { class: "rows", role: "presentation", style: { transform: `translateY(${u * t}px)` }, children: Array.from({ length: Math.max(0, c - u) }, (p, m) => n(u + m)) }) }) });
}

// src/lamps.tsx
var Co = g(""), bt = g(/* @__PURE__ */ new Set()), Eo = g("group"), Fa = G(() => {
  let e = Co.value.trim().toLowerCase(), t = (r) => {
    let i = w.get(r);
    return i ? !e || `${i.name} ${i.kind} ${O.get(i.group)?.name ?? ""}`.toLowerCase().includes(e) : !1;
  };
  if (Eo.value !== "group" && Ht.value === "sheet") {
    let r = Eo.value, i = w.all().filter(([a]) => t(a));
    return i.sort(([, a], [, l]) => r === "name" ? a.name.localeCompare(l.name, "en", { numeric: !0 }) : l[r] - a[r]), i.map(([a]) => ({ kind: "lamp", id: a, depth: 0 }));
  }
  let n = [], o = /* @__PURE__ */ new Set();
  for (let [r, i] of O.all()) {
    i.lamps.forEach((l) => o.add(l));
    let a = i.lamps.filter(t);
    if (a.length) {
      if (i.lamps.length === 1) {
        n.push({ kind: "lamp", id: a[0], depth: 0 });
        continue;
      }
      n.push({ kind: "group", id: r, depth: 0 }), (!bt.value.has(r) || e) && a.forEach((l) => n.push({ kind: "lamp", id: l, depth: 1 }));
    }
  }
  for (let r of w.ids.value) !o.has(r) && t(r) && n.push({ kind: "lamp", id: r, depth: 0 });
  return n;
}), Na = !1;
O.ids.subscribe((e) => {
  Na || !e.length || (Na = !0, w.ids.peek().length > 40 && (bt.value = new Set(e.filter((t) => (O.get(t)?.lamps.length ?? 0) > 1))));
});
function Ha(e) {
  let t = new Set(bt.peek());
  t.delete(e) || t.add(e), bt.value = t;
}
function Mo(e, t, n) {
  e.shiftKey ? ea(t, Fa.peek().filter((o) => o.kind === t).map((o) => o.id), n) : _e(t, n, e.ctrlKey || e.metaKey ? "toggle" : "only");
}
function Rl(e) {
  let t = { ArrowDown: 1, ArrowUp: -1 }[e.key], n = e.target;
  if (!t || !n.matches(".row-name")) return;
  e.preventDefault();
  let o = [...e.currentTarget.querySelectorAll(".row-name")];
  o[o.indexOf(n) + t]?.focus();
}
var Hl = ["add-spot", "add-point", "add-disc", "add-sphere"];
function qa() {
  let e = Fa.value, t = E.value?.ids[E.value.ids.length - 1], n = e.findIndex((i) => i.kind === E.value?.kind && i.id === t), o = matchMedia("(pointer: coarse)").matches, r = Ht.value === "sheet";
  return s("section", { class: "panel lamps", "aria-label": "Lamps", onKeyDown: Rl, children: [
    s("header", { class: "panel-head", children: [
      s("h2", { children: [
        "Lamps ",
        s("small", { children: B(w.ids.value.length) })
      ] }),
      s("span", { class: "gap" }),
      s("div", { class: "segments", role: "group", "aria-label": "Listing", children: [
        s("button", { "aria-pressed": !r, onClick: () => Ht.value = "faders", children: "Faders" }),
        s("button", { "aria-pressed": r, onClick: () => Ht.value = "sheet", children: "Sheet" })
      ] })
    ] }),
    s("div", { class: "panel-tools", children: [
      s("span", { class: "field filter", children: s(
        "input",
        {
          type: "text",
          "aria-label": "Filter lamps",
          placeholder: "Filter",
          value: Co.value,
          onInput: (i) => Co.value = i.currentTarget.value,
          onKeyDown: (i) => {
            i.key === "Escape" && (Co.value = "", i.stopPropagation());
          }
        }
      ) }),
      r && s("select", { "aria-label": "Order", value: Eo.value, onChange: (i) => Eo.value = i.currentTarget.value, children: [
        s("option", { value: "group", children: "by group" }),
        s("option", { value: "name", children: "by name" }),
        s("option", { value: "flux", children: "by flux" }),
        s("option", { value: "level", children: "by level" })
      ] }),
      s(Wt, { id: "add-menu", label: "Add", title: "Add a lamp", children: [
        Hl.map((i) => s(Cr, { id: i }, i)),
        s("button", { class: "item", "aria-disabled": "true", title: "Photometric files come with a later version", children: [
          s("span", { children: "IES or LDT file…" }),
          s("kbd", { children: "later" })
        ] })
      ] })
    ] }),
    re.value.length > 1 && s("p", { class: "several", children: [
      re.value.length,
      " selected; a fader moves them in proportion",
      s("button", { onClick: () => Z("none"), children: "None" })
    ] }),
    r && s(Oa, {}),
    s(
      Or,
      {
        label: "Lamps and groups",
        count: e.length,
        height: r ? o ? 44 : 28 : o ? 84 : 50,
        show: n,
        row: (i) => {
          let a = e[i];
          return s(r ? Ka : Ra, { row: a, index: i, count: e.length }, `${a.kind}${a.id}`);
        }
      }
    ),
    !e.length && w.ids.value.length > 0 && s("p", { class: "quiet empty", children: "No lamp is called so." })
  ] });
}

// src/states.ts
var Cn = g(null), tt = g([]), En = g(null), Dr = g(null), Kr = G(() => Le.value?.stage ?? "loading"), Ol = G(() => {
  let e = Le.value?.fps ?? 0;
  return Kr.value === "moving" && e > 6 && Rt.value < 0.4 * e && Rt.value < 5;
}), Gt = G(() => {
  switch (U.value) {
    case "entering":
      return "starting";
    case "open":
      break;
    default:
      return U.value;
  }
  return !ee.value || !W.value ? "loading" : lt.value.state === "failed" ? "unsaved" : Cn.value !== null ? "broken" : En.value !== null && !te.value.you ? "control-lost" : me.value === "watch" || !te.value.you ? "watching" : w.ids.value.length === 0 ? "no-lamps" : $i.value ? "all-off" : Ol.value ? "slow" : Kr.value === "loading" ? "first" : Kr.value;
});
Ce("event", (e) => {
  switch (e.what) {
    case "reloaded": {
      Cn.value = null, tt.value = e.lost ?? [];
      let t = e.kept ?? 0;
      Q(`The scene was read again: ${t} edits kept${tt.value.length ? `, ${tt.value.length} no longer find what they changed` : ""}.`);
      break;
    }
    case "broken":
      Cn.value = e.why ?? "The scene file cannot be read.";
      break;
    case "taken":
      En.value = e.by ?? te.peek().name ?? "somebody else";
      break;
    case "loading":
      Dr.value = e;
      break;
  }
});
Ce("refused", (e) => Q(e.why ?? "That could not be done.", "warn"));
T(() => {
  te.value.you && (En.value = null);
});

// src/probe.ts
var To = g(null);
function $o(e, t, n) {
  let o = Ft(e, t);
  if (!o) return n(null);
  Ee("point", o, (r) => n(r.hit ? r : null));
}
function ja(e) {
  if (!e) return "";
  let t = [], n = w.get(e.lamp)?.name, o = be.get(e.thing)?.name, r = Mt.get(e.material)?.name;
  if (n && t.push(n), o && o !== n && t.push(o), r && r !== o && t.push(r), e.lux && t.push(`${vt(e.lux[0])} ±${vt(e.lux[1], !1)}`), e.luminance) {
    let i = e.luminance[0] * (Ot.value === "fc" ? 0.2919 : 1);
    t.push(`${Re(i)} ${Ot.value === "fc" ? "fL" : "cd/m²"}`);
  }
  return t.join(" · ");
}

// src/status.tsx
var Ua = G(() => {
  W.value;
  let e = [];
  for (let t of le.sent.slice(-24)) {
    if (t.what !== "set" && t.what !== "camera") continue;
    let n = le.frames.find((o) => o.seq >= t.seq && o.painted);
    n && n.painted > t.at && e.push(n.painted - (t.input || t.at));
  }
  return e.sort((t, n) => t - n), e.length ? e[e.length >> 1] : null;
});
function Kl() {
  let e = Le.value;
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
function Wa() {
  let e = Le.value, t = W.value?.head, n = an.value.filter((r) => r.batches < r.of && !r.held).length, o = e?.stage === "refining" && e.good_in ? Math.max(0.02, 1 / (1 + e.good_in)) : e?.stage === "good" || e?.stage === "done" ? 1 : 0.02;
  return s("footer", { class: "status", "aria-label": "Status", children: [
    s("span", { class: `quality ${e?.stage ?? ""}`, children: [
      s("i", { class: "thin", "aria-hidden": "true", children: s("b", { style: { width: `${o * 100}%` } }) }),
      Kl()
    ] }),
    s("span", { children: [
      B(t?.batches ?? e?.batches ?? 0),
      " batches"
    ] }),
    s("span", { children: U.value === "open" ? `${B(Rt.value)} fps` : "no line" }),
    Ua.value !== null && s("span", { title: "From the hand to the paint, median", children: [
      B(Ua.value),
      " ms"
    ] }),
    t && s("span", { children: [
      t.width,
      " × ",
      t.height
    ] }),
    s("span", { class: "wide", children: [
      an.value.length,
      " layers",
      n ? `, ${n} tracing` : ""
    ] }),
    s("span", { class: "probe", "aria-live": "off", children: ja(To.value) }),
    s("span", { class: "gap" }),
    s("span", { children: te.value.you ? "editing: you" : `editing: ${te.value.name ?? "somebody else"}` }),
    s("span", { class: "spoken", children: [
      Jo.value ?? "",
      " ",
      Gt.value
    ] })
  ] });
}

// src/pointer.ts
var Dl = 4, Ba = 35e-4, Nl = 0.15;
function Fl(e, t, n) {
  return e === "maya" && n.alt ? ["orbit", "pan", "dolly"][t] ?? "none" : e === "blender" && t === 1 ? n.shift ? "pan" : n.ctrl ? "dolly" : "orbit" : t === 1 ? n.shift ? "pan" : "orbit" : t === 2 ? "look" : t === 0 ? n.alt ? "orbit" : n.space ? "pan" : n.shift || n.ctrl ? "none" : "look" : "none";
}
function za(e, t) {
  let n = /* @__PURE__ */ new Map(), o = qt(), r = 3, i = !1, a = 0, l = 0, d = 0, u = null, c = (h) => {
    let v = e.getBoundingClientRect();
    return [h.clientX - v.left, h.clientY - v.top];
  }, p = (h, v, $) => {
    let P = Ft(h, v);
    P && Ee("point", P, (L) => {
      let I = L;
      I.hit && $?.(I);
    });
  }, m = (h) => {
    let v = mt();
    return v ? Math.max(0.2, K(A(h, v.eye), v.forward)) : r;
  };
  function f(h) {
    if (h.target.closest("[data-handle]")) return;
    e.focus({ preventScroll: !0 });
    let [v, $] = c(h), P = h.pointerType === "touch", L = { alt: h.altKey, shift: h.shiftKey, ctrl: h.ctrlKey || h.metaKey, space: i }, I = P ? "look" : Fl(eo.peek(), h.button, L);
    I === "look" && ie()?.height && (I = "pan"), D.peek() === "marquee" && h.button === 0 && (I = "none"), n.set(h.pointerId, {
      id: h.pointerId,
      button: h.button,
      x: v,
      y: $,
      startX: v,
      startY: $,
      moved: !1,
      motion: I,
      touch: P,
      shift: h.shiftKey,
      ctrl: L.ctrl
    }), e.setPointerCapture(h.pointerId), clearTimeout(a), t.unhover(), (I === "orbit" || I === "pan" || I === "dolly") && (o = qt(), r = m(o), p(v, $, (H) => {
      o = H.point, r = m(H.point);
    })), clearTimeout(l), P && n.size === 1 && (l = window.setTimeout(() => {
      let H = n.get(h.pointerId);
      H && !H.moved && n.size === 1 && (H.moved = !0, H.motion = "none", t.menu(H.x, H.y));
    }, 550)), n.size === 2 && (u = _()), h.button === 1 && h.preventDefault();
  }
  function _() {
    let [h, v] = [...n.values()];
    return { gap: Math.hypot(h.x - v.x, h.y - v.y), x: (h.x + v.x) / 2, y: (h.y + v.y) / 2 };
  }
  function k(h) {
    let v = n.get(h.pointerId), [$, P] = c(h);
    if (!v) {
      if (h.pointerType === "touch" || h.buttons) return;
      t.unhover(), clearTimeout(a), a = window.setTimeout(() => t.hover($, P), 150);
      return;
    }
    let [L, I] = [$ - v.x, P - v.y];
    if (!(!v.moved && Math.hypot($ - v.startX, P - v.startY) < Dl)) {
      if (v.moved = !0, v.x = $, v.y = P, n.size === 2 && u) {
        let H = _();
        jt(H.x - u.x, H.y - u.y, r), H.gap > 8 && u.gap > 8 && b(H.x, H.y, u.gap / H.gap, !1), u = H;
        return;
      }
      if (D.peek() === "marquee" && v.button === 0) {
        t.marquee([v.startX, v.startY], [$, P], !1);
        return;
      }
      switch (v.motion) {
        case "look": {
          let H = v.touch ? 1 : -1;
          ro(H * L * Ba, H * I * Ba);
          break;
        }
        case "orbit":
          io(o, -L * 6e-3, -I * 6e-3);
          break;
        case "pan":
          jt(L, I, r);
          break;
        case "dolly":
          b(v.startX, v.startY, Math.exp(I * 6e-3), !1);
          break;
        case "none":
          break;
      }
    }
  }
  function S(h) {
    let v = n.get(h.pointerId);
    if (n.delete(h.pointerId), clearTimeout(l), n.size < 2 && (u = null), !(!v || h.type === "pointercancel")) {
      if (v.moved) {
        D.peek() === "marquee" && t.marquee([v.startX, v.startY], [v.x, v.y], !0);
        return;
      }
      if (v.touch) {
        let $ = performance.now(), P = $ - d < 320;
        if (d = $, P) return t.double();
        if (Ae.peek()) return;
      }
      if (v.button === 2) t.menu(v.x, v.y);
      else if (v.button === 0) {
        let $ = v.shift ? "add" : v.ctrl ? "toggle" : "only";
        t.click(v.x, v.y, $);
      }
    }
  }
  let y = null;
  function b(h, v, $, P) {
    let L = ie(), I = mt();
    if (!L || !I) return;
    if (L.height) return J(Jn(L, I, h, v, $));
    let H = performance.now();
    if (!y || H - y.time > 500 || Math.hypot(h - y.x, v - y.y) > 6) {
      y = { x: h, y: v, time: H, point: null };
      let _t = y;
      p(h, v, (Ur) => {
        _t.point = Ur.point, r = m(Ur.point);
      });
    }
    y.time = H;
    let [os, rs] = [h - I.width / 2, I.height / 2 - v], is = Math.min(r, Te(L.eye, qt()) + 1), Po = (_t) => L.eye[_t] + (I.forward[_t] + I.side[_t] * os * I.pixel + I.up[_t] * rs * I.pixel) * is, jr = y.point ?? [Po(0), Po(1), Po(2)];
    J(Qn(L, jr, $, Nl, P)), P && Te(L.eye, jr) < 0.5 && (y = null);
  }
  function R(h) {
    if (h.target.closest("[data-scroll]")) return;
    h.preventDefault();
    let v = h.deltaMode === 1 ? 18 : h.deltaMode === 2 ? 400 : 1, [$, P] = [h.deltaX * v, h.deltaY * v], [L, I] = c(h);
    if (eo.peek() === "trackpad" && !h.ctrlKey) return jt(-$, -P, r);
    let H = (h.ctrlKey ? 6 : 1) * (Math.abs(P) > Math.abs($) ? P : $);
    b(L, I, Math.exp(Math.max(-300, Math.min(300, H)) * 16e-4), h.shiftKey && !h.ctrlKey);
  }
  let V = (h) => h.preventDefault(), je = () => {
    clearTimeout(a), t.unhover();
  }, Ue = (h) => {
    !h.target.closest("[data-handle]") && D.peek() === null && t.double();
  }, Se = (h) => {
    h.code === "Space" && (i = h.type === "keydown");
  }, ge = new ResizeObserver(() => {
    let h = e.getBoundingClientRect();
    ke.value = [Math.max(16, Math.round(h.width)), Math.max(16, Math.round(h.height))];
  });
  return ge.observe(e), e.addEventListener("pointerdown", f), e.addEventListener("pointermove", k), e.addEventListener("pointerup", S), e.addEventListener("pointercancel", S), e.addEventListener("pointerleave", je), e.addEventListener("wheel", R, { passive: !1 }), e.addEventListener("contextmenu", V), e.addEventListener("dblclick", Ue), addEventListener("keydown", Se), addEventListener("keyup", Se), () => {
    ge.disconnect(), removeEventListener("keydown", Se), removeEventListener("keyup", Se);
  };
}

// src/overlay.ts
var ql = "http://www.w3.org/2000/svg";
function xe(e, t = {}, n) {
  let o = document.createElementNS(ql, e);
  for (let [r, i] of Object.entries(t)) o.setAttribute(r, String(i));
  return n?.append(o), o;
}
var Fr = class {
  view;
  fit;
  constructor(t) {
    this.view = t, this.fit = hn(t.width, t.height);
  }
  at(t) {
    let [n, o, r] = pn(this.view, t);
    return r < 0.02 && !this.view.parallel ? null : [this.fit.x + n * this.fit.scale, this.fit.y + o * this.fit.scale];
  }
  /** A line of the scene as a path, as much of it as lies before the eye. */
  line(t, n) {
    let [, , o] = pn(this.view, t), [, , r] = pn(this.view, n), i = 0.05, [a, l] = [t, n];
    if (!this.view.parallel) {
      if (o < i && r < i) return "";
      let c = (i - o) / (r - o), p = M(x(t, 1 - c), x(n, c));
      o < i && (a = p), r < i && (l = p);
    }
    let [d, u] = [this.at(a), this.at(l)];
    return !d || !u ? "" : `M${d[0].toFixed(1)} ${d[1].toFixed(1)}L${u[0].toFixed(1)} ${u[1].toFixed(1)}`;
  }
};
function qr() {
  let e = W.value;
  return ke.value, e ? new Fr(It(e.camera, e.head.width, e.head.height)) : null;
}
function Ga() {
  let e = se(qr);
  return e ? w.all().flatMap(([t, n]) => {
    let o = Xa(n), r = o && e.at(o);
    return r ? [{ id: t, at: r }] : [];
  }) : null;
}
var Xa = so, jl = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
function Nr(e, t) {
  let n = Vt(t);
  return jl.map(([o, r]) => e.line(n[o], n[r])).join("");
}
var Tn = class {
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
      let l = this.marks.get(o);
      if (!l) {
        let d = xe("g", { "data-kind": this.kind, "data-id": o }, this.parent);
        this.shape(d);
        let u = xe("text", { x: 10, y: 4 }, d);
        l = { group: d, label: u }, this.marks.set(o, l);
      }
      if (!r) {
        l.group.setAttribute("display", "none");
        continue;
      }
      l.group.removeAttribute("display"), l.group.setAttribute("transform", `translate(${r[0].toFixed(1)} ${r[1].toFixed(1)})`), l.group.setAttribute("class", `mark ${this.kind} ${a}`), l.label.textContent !== i && (l.label.textContent = i);
    }
    for (let [o, r] of this.marks)
      n.has(o) || (r.group.remove(), this.marks.delete(o));
  }
};
function Ya(e) {
  let t = xe("path", { class: "aims" }, e), n = xe("path", { class: "boxes" }, e), o = xe("path", { class: "boxes hover" }, e), r = xe("path", { class: "grid-lines" }, e), i = new Tn(xe("g", {}, e), "lamp", (c) => xe("circle", { r: 4.5 }, c)), a = new Tn(xe("g", {}, e), "grid", () => {
  }), l = new Tn(xe("g", {}, e), "meter", (c) => {
    xe("circle", { r: 5.5 }, c), xe("path", { d: "M-9 0H9M0 -9V9" }, c);
  }), d = T(() => {
    let c = qr();
    if (!c) return;
    let p = E.value, m = ne.value, f = "", _ = "", k = w.all().map(([y, b]) => {
      let R = p?.kind === "lamp" ? p.ids.includes(y) : p?.kind === "group" && p.ids.includes(b.group ?? -1), V = m?.kind === "lamp" ? m.id === y : m?.kind === "group" && m.id === b.group, je = Xa(b), Ue = b.place?.position;
      if (R && b.box && (_ += Nr(c, b.box)), Ue && b.place?.direction && (R || V)) {
        let h = b.place.aim ?? M(Ue, b.place.direction);
        f += c.line(Ue, h);
      }
      let Se = R || V || ur.value && (b.own || b.place?.position), ge = `${R ? "selected" : ""} ${V ? "under" : ""} ${ye(b) ? "" : "off"}`;
      return { id: y, at: je && Se ? c.at(je) : null, label: R || V ? b.name : "", state: ge };
    });
    if (i.draw(k), t.setAttribute("d", f), p?.kind === "thing")
      for (let y of p.ids) {
        let b = be.get(y)?.box;
        b && (_ += Nr(c, b));
      }
    n.setAttribute("d", _);
    let S = m?.kind === "lamp" ? w.get(m.id)?.box : m?.kind === "thing" ? be.get(m.id)?.box : null;
    o.setAttribute("d", S ? Nr(c, S) : "");
  }), u = T(() => {
    let c = qr();
    if (!c) return;
    let p = E.value, m = (_, k) => p?.kind === _ && p.ids.includes(k) ? "selected" : "";
    l.draw(Ke.all().map(([_, k]) => ({
      id: _,
      at: c.at(k.point),
      label: k.lux ? vt(k.lux[0]) : "…",
      state: m("meter", _)
    })));
    let f = "";
    a.draw(at.all().map(([_, k]) => {
      f += Ul(c, k);
      let S = k.mean === null ? "…" : `${k.name} ${vt(k.mean)}`;
      return { id: _, at: c.at(k.corner), label: S, state: m("grid", _) };
    })), r.setAttribute("d", f);
  });
  return () => {
    d(), u(), e.replaceChildren();
  };
}
function Ul(e, t) {
  let n = (r, i) => M(t.corner, M(x(t.u, r), x(t.v, i))), o = e.line(n(0, 0), n(1, 0)) + e.line(n(1, 0), n(1, 1)) + e.line(n(1, 1), n(0, 1)) + e.line(n(0, 1), n(0, 0));
  for (let r = 0; r < t.rows; r++)
    for (let i = 0; i < t.columns; i++) {
      let a = e.at(n((i + 0.5) / t.columns, (r + 0.5) / t.rows));
      a && (o += `M${(a[0] - 2).toFixed(1)} ${a[1].toFixed(1)}h4m-2 -2v4`);
    }
  return o;
}

// src/banner.tsx
function de({ tone: e, children: t }) {
  return s("div", { class: `banner ${e}`, role: e === "warn" ? "alert" : "status", children: t });
}
var Qa = () => `lampyris view ${ee.peek()?.file ?? "SCENE"} --port ${location.port || 80}`;
function Wl() {
  let e = w.all().filter(([, n]) => !n.on || n.level === 0 || n.parked), t = O.all().filter(([, n]) => !n.on || n.level === 0);
  ce("All lamps on", {
    lamps: Object.fromEntries(e.map(([n, o]) => [n, { on: !0, parked: !1, ...o.level === 0 ? { level: 1 } : {} }])),
    groups: Object.fromEntries(t.map(([n, o]) => [n, { on: !0, ...o.level === 0 ? { level: 1 } : {} }]))
  });
}
function Bl() {
  switch (Gt.value) {
    case "starting":
      return s(de, { tone: "calm", children: "Entering…" });
    case "loading": {
      let e = Dr.value;
      return s(de, { tone: "calm", children: [
        "Reading ",
        e?.file ?? ee.value?.file ?? "the scene",
        "…",
        e?.bytes ? ` ${B(e.bytes / 1e6, 1)} MB` : "",
        e?.progress != null && s("progress", { value: e.progress, max: 1, "aria-label": "Reading" })
      ] });
    }
    case "lost":
      return s(de, { tone: "warn", children: [
        "Connection lost, trying again",
        un.value ? ` (${un.value} s)` : "…",
        ". Until then nothing can be changed."
      ] });
    case "ended":
      return s(de, { tone: "warn", children: [
        "The program has ended. Start it again with ",
        s("code", { children: Qa() }),
        s("button", { onClick: () => {
          xr(Qa());
        }, children: "Copy" }),
        " and this page comes back by itself."
      ] });
    case "denied":
      return s(de, { tone: "warn", children: "This link is not valid (any more). Open the one that the program has printed, or ask for a new one." });
    case "renewed":
      return s(de, { tone: "warn", children: [
        "New version. ",
        s("button", { onClick: () => location.reload(), children: "Reload" })
      ] });
    case "unsaved":
      return s(de, { tone: "warn", children: [
        "Edits are not being saved: ",
        lt.value.why ?? "unknown reason",
        ".",
        s("button", { onClick: () => ht.value = "save", children: "Save elsewhere" })
      ] });
    case "broken":
      return s(de, { tone: "warn", children: [
        Cn.value,
        " Still showing what was read before."
      ] });
    case "control-lost":
      return s(de, { tone: "warn", children: [
        "Control moved to ",
        s("em", { children: En.value }),
        ". ",
        s("button", { onClick: () => F({ do: "edit", what: "take" }), children: "Take it back" })
      ] });
    case "watching":
      return s(de, { tone: "calm", children: [
        "You are watching",
        te.value.name ? s(X, { children: [
          "; ",
          s("em", { children: te.value.name }),
          " edits"
        ] }) : "",
        ".",
        s("button", { onClick: () => F({ do: "edit", what: "take" }), children: "Ask for control" })
      ] });
    case "no-lamps":
      return s(de, { tone: "calm", children: [
        "This scene has no light. Add:",
        s(
          "button",
          {
            onClick: () => {
              ao.value = "disc", br("add");
            },
            children: "ceiling lamp"
          }
        ),
        s("button", { disabled: !0, title: "Photometric files come with a later version", children: "IES file" })
      ] });
    case "all-off":
      return s(de, { tone: "warn", children: [
        "All lamps are off.",
        st.value.undo && s("button", { onClick: () => Z("undo"), children: "Undo" }),
        s("button", { onClick: Wl, children: "Turn on" })
      ] });
    case "slow":
      return s(de, { tone: "calm", children: [
        "Slow connection.",
        s("button", { "aria-pressed": Ye.value, onClick: () => Ye.value = !0, children: "Sharper" }),
        s("button", { "aria-pressed": !Ye.value, onClick: () => Ye.value = !1, children: "Faster" })
      ] });
    default:
      return null;
  }
}
function Ja() {
  let e = Me.value;
  return s("div", { class: "banners", "data-scroll": !0, children: [
    Bl(),
    tt.value.length > 0 && s(de, { tone: "calm", children: [
      s("details", { children: [
        s("summary", { children: [
          tt.value.length,
          " edits no longer find what they changed"
        ] }),
        s("ul", { children: tt.value.map((t) => s("li", { children: t }, t)) })
      ] }),
      s("button", { onClick: () => tt.value = [], children: "Good" })
    ] }),
    e.length > 0 && s("div", { class: "banner badge", role: "status", children: [
      "Solo: ",
      e.length === 1 ? w.get(e[0])?.name ?? "one lamp" : `${e.length} lamps`,
      s("button", { onClick: Tr, children: "End solo" })
    ] }),
    s("div", { class: "notes", role: "status", "aria-live": "polite", children: ct.value.map((t) => s("div", { class: `banner ${t.tone === "warn" ? "warn" : "calm"}`, children: [
      t.text,
      s("button", { class: "icon", "aria-label": "Close", onClick: () => Xo(t.id), children: s(j, { name: "close" }) })
    ] }, t.id)) })
  ] });
}

// src/view.tsx
var es = g(null);
function zl(e, t) {
  let n = Ga();
  if (!n) return [];
  let [o, r] = [Math.min(e[0], t[0]), Math.max(e[0], t[0])], [i, a] = [Math.min(e[1], t[1]), Math.max(e[1], t[1])];
  return n.filter(({ at: l }) => l[0] >= o && l[0] <= r && l[1] >= i && l[1] <= a).map(({ id: l }) => l);
}
var Gl = {
  click(e, t, n) {
    let o = Za(e, t);
    if (D.peek() === null && o) return _e(o.kind, o.id, n);
    $o(e, t, (r) => {
      if (r && (oo.value = { point: r.point, normal: r.normal }), D.peek() !== null) return sa(r);
      na(r, n);
    });
  },
  menu(e, t) {
    $o(e, t, (n) => {
      n && ho(e, t, n);
    });
  },
  double() {
    vr();
  },
  hover(e, t) {
    let n = Za(e, t);
    n?.kind === "lamp" && (ne.value = { kind: "lamp", id: n.id }), $o(e, t, (o) => {
      To.value = o, o && (oo.value = { point: o.point, normal: o.normal }), o?.lamp != null && (ne.value = { kind: "lamp", id: o.lamp });
    });
  },
  unhover() {
    ne.peek() && (ne.value = null);
  },
  marquee(e, t, n) {
    if (es.value = n ? null : { from: e, to: t }, !n) return;
    let o = zl(e, t);
    E.value = o.length ? { kind: "lamp", ids: o } : null, D.value = null;
  }
};
function Za(e, t) {
  let n = document.getElementById("overlay"), o = null, r = 11;
  for (let i of n?.querySelectorAll(".mark:not([display])") ?? []) {
    let a = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(i.getAttribute("transform") ?? "");
    if (!a) continue;
    let l = Math.hypot(Number(a[1]) - e, Number(a[2]) - t);
    l < r && (r = l, o = { kind: i.dataset.kind, id: Number(i.dataset.id) });
  }
  return o;
}
var Xl = {
  aim: "Click what shall be lit. Esc to leave.",
  meter: "Click where the meter shall lie. Esc to leave.",
  grid: "Click two opposite corners of the area. Esc to leave.",
  add: "Click where the lamp shall hang. Esc to leave.",
  marquee: "Drag around the lamps to select. Esc to leave."
};
function ts() {
  let e = oe(null), t = oe(null), n = oe(null);
  return $e(() => {
    or(t.current);
    let o = Ya(n.current), r = za(e.current, Gl);
    return () => {
      or(null), o(), r();
    };
  }, []), Mi(() => {
    let o = W.value;
    t.current?.setAttribute("data-kind", o?.head.kind ?? "none");
  }), s("main", { class: "view", "aria-label": "View", children: [
    s(
      "div",
      {
        class: D.value ? "stage tooled" : "stage",
        id: "view",
        ref: e,
        tabIndex: 0,
        role: "application",
        "aria-label": `View of ${ee.value?.name ?? "the scene"}${Nt.value ? `, ${Nt.value}` : ""}`,
        "aria-describedby": "view-keys",
        "data-tool": D.value ?? "",
        children: [
          s("canvas", { ref: t, width: 640, height: 480, "aria-hidden": "true" }),
          s("svg", { id: "overlay", ref: n, "aria-hidden": "true" }),
          s(ae, { part: "Gizmo" }),
          s(ae, { part: "Compare" }),
          s(Yl, {})
        ]
      }
    ),
    s("p", { id: "view-keys", class: "spoken", children: "Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection, Escape leaves the view." }),
    D.value && s("p", { class: "hint", role: "status", children: Xl[D.value] }),
    s(Ja, {}),
    s(ae, { part: "Legend" }),
    s(ae, { part: "CutBar" }),
    s(ae, { part: "ViewStrip" }),
    s(ae, { part: "WalkPad" }),
    s(ae, { part: "What" })
  ] });
}
function Yl() {
  let e = es.value;
  if (!e) return null;
  let { from: t, to: n } = e;
  return s("svg", { class: "rubber", "aria-hidden": "true", children: s(
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
function Ql() {
  return s(X, { children: [
    s(_a, {}),
    s(qa, {}),
    s(ts, {}),
    s("section", { class: "panel inspector", "aria-label": "Inspector", children: s(ae, { part: "Inspector" }) }),
    s("section", { class: "strip", "aria-label": "Looks and meters", children: s(ae, { part: "Strip" }) }),
    s(Wa, {}),
    s(ae, { part: "Sheets" })
  ] });
}
var yt = document.getElementById("desk");
yt.replaceChildren();
oi(s(Ql, {}), yt);
T(() => {
  yt.dataset.state = Gt.value, yt.dataset.line = U.value, yt.dataset.pen = me.value === "edit" && te.value.you && !Ae.value ? "yes" : "no";
});
T(() => {
  yt.dataset.panels = sr.value ? "yes" : "no", yt.dataset.drawer = Ze.value ?? "none";
});
T(() => {
  document.documentElement.dataset.theme = rr.value, document.documentElement.style.setProperty("--house", String(ir.value));
});
T(() => {
  ee.value && (document.title = `${ee.value.name} – Lampyris`);
});
var ns = 0;
T(() => {
  let [e, t] = ke.value, n = Ye.value ? Math.min(devicePixelRatio, 2) : 1;
  U.value === "open" && (clearTimeout(ns), ns = window.setTimeout(() => F({ do: "size", width: Math.round(e * n), height: Math.round(t * n) }), 60));
});
ha();
La();
Oi();
export {
  xn as Fade,
  gt as Field,
  X as Fragment,
  Ne as Gesture,
  j as Icon,
  Cr as Item,
  Rs as PRESETS,
  Hr as Range,
  Or as Virtual,
  pt as across,
  Z as act,
  M as add,
  ua as addMeter,
  ao as adding,
  la as aim,
  pl as allActions,
  Ee as ask,
  Bs as back,
  bn as before,
  Ot as candles,
  re as chosenLamps,
  Tr as clearSolo,
  vo as closeWhat,
  uo as command,
  yn as compareHeld,
  ve as comparing,
  Gi as compass,
  G as computed,
  nl as copyAlong,
  xr as copyText,
  fe as cross,
  Mn as css,
  Js as cut,
  no as deselect,
  B as digits,
  ut as display,
  Te as distance,
  K as dot,
  al as each,
  ce as edit,
  te as editor,
  T as effect,
  co as exposeBy,
  cr as fade,
  ll as falseColor,
  Es as filterOf,
  Ye as fine,
  hn as fitted,
  _n as format,
  zs as forth,
  vr as frameSelection,
  Il as fromHex,
  J as go,
  gr as goHome,
  Qs as goInside,
  Ys as goPreset,
  at as grids,
  O as groups,
  js as handles,
  eo as hands,
  Ce as hear,
  ie as here,
  Ia as hex,
  mo as highlight,
  st as history,
  ir as houseLights,
  ne as hovered,
  s as jsx,
  s as jsxs,
  ur as lampMarks,
  w as lamps,
  an as layers,
  Fe as length,
  Ht as listing,
  Ae as lookOnly,
  Et as looks,
  vt as luxText,
  Fs as maintenance,
  Mt as materials,
  Ke as meters,
  Ge as middle,
  Al as mired,
  ta as nameOf,
  q as normal,
  ye as output,
  Tl as padWalk,
  sr as panels,
  He as percent,
  It as pinhole,
  rl as placed,
  so as positionOf,
  il as positions,
  pn as project,
  As as ray,
  fl as register,
  ol as removeLamps,
  me as role,
  Q as say,
  x as scale,
  ee as scene,
  _e as select,
  E as selection,
  F as send,
  Zs as setCut,
  ht as sheet,
  Lt as show,
  W as shown,
  g as signal,
  lr as singleKeys,
  yl as soloSelection,
  ca as spacing,
  oo as spot,
  br as startTool,
  Le as status,
  Us as stepSelection,
  cl as storeLook,
  ul as storeView,
  Zo as stroke,
  _o as strokeLevel,
  A as sub,
  rr as theme,
  be as things,
  Re as three,
  Qe as titleOf,
  Ar as toLevel,
  Ir as toTravel,
  kr as toggleFalse,
  hl as toggleWipe,
  D as tool,
  to as travel,
  fn as turn,
  Sn as typeLevel,
  he as up,
  $e as useEffect,
  oe as useRef,
  Nt as viewName,
  ke as viewSize,
  Ct as views,
  $a as walkNames,
  ar as walking,
  wr as wantLevel,
  et as what,
  Gn as whyNot,
  Sr as whyNotTo,
  dl as wipeAt
};
