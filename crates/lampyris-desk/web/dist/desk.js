// node_modules/preact/dist/preact.mjs
var C, Xr, Co, We, So, Ln, Yr, Pn, Qr, Eo, Mo, as, Xt = /* @__PURE__ */ Symbol.for("pv"), Vn = {}, In = [], ss = /^m(i|n|o|s|text|space)$/, To = Array.isArray, Po = In.slice, ot = Object.assign;
function nt(e) {
  e && e.parentNode && e.remove();
}
function Jr(e, t, n) {
  var o, r, i, a = {}, s = arguments.length;
  for (i in t) i == "key" ? o = t[i] : i == "ref" && typeof e != "function" ? r = t[i] : a[i] = t[i];
  return s > 2 && (a.children = s > 3 ? Po.call(arguments, 2) : n), zt(e, a, o, r, null);
}
function zt(e, t, n, o, r) {
  var i = { type: e, props: t, key: n, ref: o, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: Xt, __v: r || ++Xr, __i: -1, __u: 0 };
  return !r && C.vnode && C.vnode(i), i;
}
function Y(e) {
  return e.children;
}
function _t(e, t) {
  this.props = e, this.context = t, this.__g = 0;
}
function Be(e, t) {
  if (t == null) return e.__ && Be(e.__, e.__i + 1);
  for (var n; t < e.__k.length; t++) if ((n = e.__k[t]) && n.__e) return n.__e;
  return typeof e.type != "function" || e.props.__P ? null : Be(e);
}
function ls(e) {
  var t, n = e.__v, o = n.__e, r = [], i = [], a = e.__P;
  a && ((t = ot({ constructor: Xt }, n)).__v = n.__v + 1, C.vnode && C.vnode(t), $o(a, t, n, e.__n, a.namespaceURI, 32 & n.__u ? [o] : null, r, o || Be(n), 32 & n.__u, i), t.__v = n.__v, t.__.__k[t.__i] = t, ri(r, t, i), n.__ = n.__e = null, t.__e != o && Zr(t));
}
function Zr(e) {
  if ((e = e.__) && e.__c && !e.props.__P) return e.__e = null, e.__k.some(function(t) {
    return t && (e.__e = t.__e);
  }), Zr(e);
}
function Gr(e) {
  (8 & e.__g || (e.__g |= 8, We.push(e), Ln++)) && So == C.debounceRendering || ((So = C.debounceRendering) || queueMicrotask)(ei);
}
function ei() {
  try {
    for (var e, t = 1; We.length; ) We.length > t && We.sort(Yr), e = We.shift(), t = We.length, 8 & e.__g && ls(e);
  } finally {
    (Ln = We.length) && (So || queueMicrotask)(ei);
  }
}
function ti(e, t, n, o, r, i, a, s, p, c, u) {
  var d, m, f, _, w, S, y = o.__k || In, b = t.length;
  for (p = us(n, t, y, p, b), d = 0; d < b; d++) (f = n.__k[d]) != null && (m = ~f.__i && y[f.__i] || Vn, f.__i = d, S = $o(e, f, m, r, i, a, s, p, c, u), _ = f.__e, (m.ref != f.ref || 8 & m.__u) && (m.ref && Lo(m.ref, null, f, m), f.ref && u.push(f.ref, f.__c || _, f)), w = w || _, 4 & f.__u ? (p = ni(f, p, e, !m.__v), m.__e && (m.__e = null)) : typeof f.type == "function" && S !== void 0 ? p = S : _ && (p = _.nextSibling), f.__u &= -21);
  return n.__e = w, p;
}
function us(e, t, n, o, r) {
  var i, a, s, p, c, u, d, m, f, _ = n.length, w = _, S = 0, y = 0, b = e.__k = Array(r);
  for (i = 0; i < r; i++) (a = t[i]) != null && typeof a != "boolean" && typeof a != "function" ? (typeof a != "object" || a.constructor === String ? a = b[i] = zt(null, a) : To(a) ? a = b[i] = zt(Y, { children: a }) : a.constructor === Xt && a.__b ? a = b[i] = zt(a.type, a.props, a.key, a.ref, a.__v) : b[i] = a, p = i + S, a.__ = e, a.__b = e.__b + 1, s = null, ~(c = a.__i = cs(a, n, p, w)) && (w--, (s = n[c]) && (s.__u |= 2)), s && s.__v ? (a.__u |= 16, c == p - 1 ? S-- : c == p + 1 ? S++ : c != p && (c > p ? S-- : S++, y = 1)) : (~c || (r > _ ? S-- : r < _ && S++), typeof a.type != "function" && (a.__u |= 4))) : b[i] = null;
  if (y) {
    for (u = [], d = [], i = 0; i < r; i++) if ((a = b[i]) && 16 & a.__u) {
      for (S = 0, m = u.length; S < m; ) u[f = S + m >> 1] < a.__i ? S = f + 1 : m = f;
      u[S] = a.__i, d[i] = S + 1;
    }
    for (S = u.length; i--; ) d[i] && (d[i] == S ? S-- : b[i].__u |= 4);
  }
  if (w) for (i = 0; i < _; i++) !(s = n[i]) || 2 & s.__u || (s.__e == o && (o = Be(s)), Vo(s, s));
  return o;
}
function ni(e, t, n, o) {
  var r, i, a, s;
  if (typeof e.type == "function") {
    if (e.props.__P) return t;
    if (r = e.__k) for (i = 0; i < r.length; i++) r[i] && (r[i].__ = e, t = ni(r[i], t, n, !1));
    return t;
  }
  for (t && !t.parentNode && (t = Be(e)) && !t.parentNode && (t = null), a = e.__e, s = t; s && s.nodeType == 8; ) s = s.nextSibling;
  for (a != s && (!o && n.moveBefore && a.parentNode ? n.moveBefore(a, t) : n.insertBefore(a, t || null)), t = a; (t = t && t.nextSibling) && t.nodeType == 8 && !t.data.startsWith("$s"); ) ;
  return t;
}
function cs(e, t, n, o) {
  var r, i = e.key, a = e.type, s = t[n], p = s && !(2 & s.__u);
  if (s === null && i == null || p && i == s.key && a == s.type) return n;
  if (o > (p ? 1 : 0)) {
    for (r = n - 1; r >= 0; r--) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
    for (r = n + 1; r < t.length; r++) if ((s = t[r]) && !(2 & s.__u) && i == s.key && a == s.type) return r;
  }
  return -1;
}
function zr(e, t, n) {
  n == null && (n = ""), t[0] == "-" ? e.setProperty(t, n) : e[t] = n;
}
function Tn(e, t, n, o, r) {
  var i, a;
  if (t == "style") if (typeof n == "string") e.style.cssText = n;
  else {
    if (typeof o == "string" && (e.style.cssText = o = ""), o) for (t in o) n && t in n || zr(e.style, t);
    if (n) for (t in n) o && n[t] == o[t] || zr(e.style, t, n[t]);
  }
  else if (t[0] == "o" && t[1] == "n") typeof n != "function" && (n = null), typeof o != "function" && (o = null), (e.__e || (e.__e = {}))[t] = n, n && o || (a = Mo[t] || (Mo[t] = fs(t)), (e.__a || (e.__a = {}))[t] = Eo, i = t != (t = t.replace(Qr, "$1")), (t = t.slice(2))[0] < "a" && (t = t.toLowerCase()), n ? e.addEventListener(t, a, i) : e.removeEventListener(t, a, i));
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
      if (n = n[e], t[Pn] == null) t[Pn] = Eo++;
      else if (t[Pn] < this.__a[e]) return;
      return n(C.event ? C.event(t) : t);
    }
  };
}
function $o(e, t, n, o, r, i, a, s, p, c) {
  var u, d, m, f, _, w, S, y, b, R, V, qe, Ue, ke, ge, h, v, P, $ = t.type;
  if (t.constructor !== Xt) return null;
  128 & n.__u && (p = 32 & n.__u, u = n.__c.__z) && (t.__u |= p, d = i = [], u.nodeType == 8 ? s = $n(u, i) : i.push(u), s = i[0] || s), (u = C.__b) && u(t);
  e: if (typeof $ == "function") {
    m = a.length;
    try {
      if (y = t.props, b = (u = $.prototype) && u.render, R = (u = $.contextType) && o[u.__c], V = u ? R ? R.props.value : u.__ : o, (f = n.__c) ? (t.__c = f, 2 & f.__g && (f.__g |= 1)) : (b ? t.__c = f = new $(y, V) : (t.__c = f = new _t(y, V), f.constructor = $, f.render = ds), R && R.sub(f), f.state || (f.state = {}), f.__n = o, f.__g |= 8, f.__h = [], f.__k = []), b && (f.__s || (f.__s = f.state), $.getDerivedStateFromProps && (f.__s == f.state && (f.__s = ot({}, f.__s)), ot(f.__s, $.getDerivedStateFromProps(y, f.__s)))), _ = f.props, w = f.state, f.__v = t, n.__c) {
        if (y !== _ && b && !$.getDerivedStateFromProps && f.componentWillReceiveProps && f.componentWillReceiveProps(y, V), t.__v == n.__v && !(8 & f.__g) || !(4 & f.__g) && f.shouldComponentUpdate && f.shouldComponentUpdate(y, f.__s, V) === !1) {
          t.__v != n.__v && (f.props = y, f.state = f.__s, f.__g &= -9), t.__e = n.__e, t.__k = n.__k, t.__k.some(function(L) {
            L && (L.__ = t);
          }), In.push.apply(f.__h, f.__k), f.__k = [], f.__h.length && a.push(f), s = Be(n);
          break e;
        }
        f.componentWillUpdate && f.componentWillUpdate(y, f.__s, V), b && f.componentDidUpdate && f.__h.push(function() {
          f.componentDidUpdate(_, w, S);
        });
      } else b && !$.getDerivedStateFromProps && f.componentWillMount && f.componentWillMount(), b && f.componentDidMount && f.__h.push(f.componentDidMount);
      f.context = V, f.props = y, f.__P = e, f.__g &= -5, qe = C.__r, Ue = b ? 25 : 0;
      do
        f.__g &= -9, qe && qe(t), u = f.render(f.props, f.state = f.__s, f.context);
      while (8 & f.__g && ++Ue < 25);
      b && (In.push.apply(f.__h, f.__k), f.__k = []), f.state = f.__s, f.getChildContext && (o = ot({}, o, f.getChildContext())), b && n.__c && f.getSnapshotBeforeUpdate && (S = f.getSnapshotBeforeUpdate(_, w)), ke = u && u.type === Y && u.key == null ? u.props.children : u, y.__P && (u = s, r = (e = y.__P).namespaceURI, p = i = null, n.props && n.props.__P != e && (n.__k.some(function(L) {
        L && Vo(L, L);
      }), n.__k = null), s = n.__k ? Be(n, 0) : null), s = ti(e, To(ke) ? ke : [ke], t, n, o, r, i, a, s, p, c), y.__P && (t.__e = null, s = u), t.__u &= -161, d && d.some(nt), f.__h.length && a.push(f), 1 & f.__g && (f.__g &= -4);
    } catch (L) {
      if (a.length = m, t.__v = null, p || i) if (L && L.then) {
        if (t.__u |= 128 | p, i) {
          for (~(v = i.indexOf(s || void 0)) || (v = i.length); (P = i[v - 1]) && P.nodeType == 8; ) v--;
          for (; v < i.length; v++) if (P = i[v]) if (i[v] = null, ge) {
            if (P == h) break;
          } else {
            if (P.nodeType != 8) break;
            P.data.startsWith("$s") && (h = $n(ge = P));
          }
        }
        if (!ge) {
          for (; s && s.nodeType == 8 && s.nextSibling; ) s = s.nextSibling;
          ge = s;
        }
        (u = $n(ge = t.__c.__z || (t.__c.__z = ge))) ? (t.__e = ge, s = u) : t.__e = s, s = s && s.nextSibling;
      } else i && i.some(nt);
      else t.__e = n.__e;
      t.__k || (t.__k = n.__k || []), L && L.then || oi(t), C.__e(L, t, n);
    }
  } else s = t.__e = ps(n.__e, t, n, o, r, i, a, p, c, e);
  return (u = C.diffed) && u(t), s;
}
function $n(e, t) {
  if (e && e.nodeType == 8 && e.data.startsWith("$s")) for (var n = 1; e = e.nextSibling; ) {
    if (e.nodeType == 8) {
      if (e.data.startsWith("$s")) n++;
      else if (e.data.startsWith("/$s") && !--n) return e;
    }
    t && t.push(e);
  }
}
function oi(e) {
  e && (e.__c && (e.__c.__g |= 4), e.__k && e.__k.some(oi));
}
function ri(e, t, n) {
  for (var o = 0; o < n.length; ) Lo(n[o++], n[o++], n[o++]);
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
function ps(e, t, n, o, r, i, a, s, p, c) {
  var u, d, m, f, _, w, S, y, b = n.props || Vn, R = t.props, V = t.type;
  if (V == "svg" ? r = "http://www.w3.org/2000/svg" : V == "math" ? r = "http://www.w3.org/1998/Math/MathML" : r || (r = "http://www.w3.org/1999/xhtml"), i) {
    for (u = 0; u < i.length; u++) if ((_ = i[u]) && (V ? _.localName == V : _.nodeType == 3)) {
      e = _, i[u] = null;
      break;
    }
  }
  if (!e) {
    if (y = c.ownerDocument || document, !V) return y.createTextNode(R);
    e = y.createElementNS(r, V, R.is ? R : c), s && (C.__m && C.__m(t, i), s = !1), i = null;
  }
  if (V) {
    if (c = V == "template" && e.content || e, i = V == "textarea" && R.defaultValue != null ? null : i && Po.call(c.childNodes), !s && i) for (b = {}, u = 0; u < e.attributes.length; u++) b[(_ = e.attributes[u]).name] = _.value;
    for (u in b) _ = b[u], u == "dangerouslySetInnerHTML" ? m = _ : u == "children" || u in R || u == "value" && "defaultValue" in R || u == "checked" && "defaultChecked" in R || Tn(e, u, null, _, r);
    for (u in R) _ = R[u], u == "children" ? f = _ : u == "dangerouslySetInnerHTML" ? d = _ : u == "value" ? w = _ : u == "checked" ? S = _ : s && typeof _ != "function" || b[u] === _ || Tn(e, u, _, b[u], r);
    d ? (s || m && (d.__html == m.__html || d.__html == e.innerHTML) || (e.innerHTML = d.__html), t.__k = []) : (m && (e.textContent = ""), (V == "foreignObject" || r == "http://www.w3.org/1998/Math/MathML" && ss.test(V)) && (r = "http://www.w3.org/1999/xhtml"), ti(c, To(f) ? f : [f], t, n, o, r, i, a, i ? i[0] : n.__k && Be(n, 0), s, p), i && i.some(nt)), s && V != "textarea" || (u = "value", V == "progress" && w == null ? e.removeAttribute(u) : w == null || w === e[u] && (V != "progress" || w) || Tn(e, u, w, b[u], r), u = "checked", S != null && S != e[u] && Tn(e, u, S, b[u], r));
  } else b === R || s && e.data == R || (e.data = R);
  return e;
}
function Lo(e, t, n, o) {
  try {
    typeof e == "function" ? t ? t.__x = e(t) || 1 : o && (o = o.__c || o.__e) && (t = o.__x) && (o.__x = null, typeof t == "function" ? t() : e(null)) : e.current = t;
  } catch (r) {
    C.__e(r, n);
  }
}
function Vo(e, t, n) {
  var o, r, i, a;
  if (C.unmount && C.unmount(e), !(o = e.ref) || o.current && o.current != e.__e || Lo(o, null, t, e), o = e.__c) {
    if (o.componentWillUnmount) try {
      o.componentWillUnmount();
    } catch (s) {
      C.__e(s, t);
    }
    o.__P = o.__n = null;
  }
  if (o = e.__k) for (a = 0; a < o.length; a++) o[a] && Vo(o[a], t, typeof e.type != "function" || n && !e.props.__P);
  !n && (o = e.__c) && (o = o.__z) && (r = $n(o, i = [])) && (o == e.__e && i.some(nt), nt(r), nt(o)), n || nt(e.__e), e.__e = e.__c = e.__ = null;
}
function ds(e, t, n) {
  return this.constructor(e, n);
}
function ii(e, t) {
  var n, o, r, i;
  C.__ && C.__(e, t), t.nodeType == 9 && (t = t.documentElement), o = (n = e && 32 & e.__u) ? null : t.__k, t.__k = zt(Y, { children: [e] }), r = [], i = [], $o(t, t.__k, o || Vn, Vn, t.namespaceURI, o ? null : t.firstChild ? Po.call(t.childNodes) : null, r, o ? o.__e : t.firstChild, n, i), ri(r, t.__k, i), t.__k.props.children = null;
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
  throw Ln = 0, e;
} }, Xr = 0, Co = function(e) {
  return e != null && e.constructor === Xt;
}, _t.prototype.setState = function(e, t) {
  var n = this.__s;
  n && n != this.state || (n = this.__s = ot({}, this.state)), typeof e == "function" && (e = e(ot({}, n), this.props)), e && (ot(n, e), this.__v && (t && this.__k.push(t), Gr(this)));
}, _t.prototype.forceUpdate = function(e) {
  this.__v && (this.__g |= 4, e && this.__h.push(e), Gr(this));
}, _t.prototype.render = Y, We = [], Ln = 0, Yr = function(e, t) {
  return e.__v.__b - t.__v.__b;
}, Pn = /* @__PURE__ */ Symbol(), Qr = /(PointerCapture)$|Capture$/i, Eo = 0, Mo = {}, as = 0;

// node_modules/preact/hooks/dist/hooks.mjs
var Qt, ae, Io, ai, ms = Object.is, Ao = 0, hi = [], Ro = [], q = C, si = q.__b, li = q.__r, ui = q.diffed, ci = q.__c, fi = q.unmount, pi = q.__;
function Oo(e, t) {
  q.__h && q.__h(ae, e, Ao || t), Ao = 0;
  var n = ae.__H || (ae.__H = { __: [], __h: [] });
  return e >= n.__.length && n.__.push({}), n.__[e];
}
function Ee(e, t) {
  var n = Oo(Qt++, 3);
  !q.__s && Ho(n.__H, t) && (n.__P = !0, n.__ = e, n.u = t, ae.__H.__h.push(n));
}
function hs(e, t) {
  var n = Oo(Qt++, 4);
  !q.__s && Ho(n.__H, t) && (n.__P = !1, n.__ = e, n.u = t, ae.__h.push(n));
}
function ne(e) {
  return Ao = 5, An(function() {
    return { current: e };
  }, []);
}
function An(e, t) {
  var n = Oo(Qt++, 7);
  return Ho(n.__H, t) && (n.__ = e(), n.__H = t), n.__;
}
function vs() {
  var e;
  do {
    for (; e = Ro.shift(); ) try {
      Yt(e);
    } catch (n) {
      q.__e(n, { __: (e = e.__P) && e.__v });
    }
    for (; e = hi.shift(); ) {
      var t = e.__H;
      if (e.__P && t) try {
        t.__h.some(Yt), t.__h.some(Ko), t.__h = [];
      } catch (n) {
        t.__h = [], q.__e(n, e.__v);
      }
    }
  } while (Ro.length);
}
q.__b = function(e) {
  ae = null, si && si(e);
}, q.__ = function(e, t) {
  e && t.__k && t.__k.__m && (e.__m = t.__k.__m), pi && pi(e, t);
}, q.__r = function(e) {
  li && li(e), Qt = 0;
  var t = (ae = e.__c).__H;
  t && (Io == ae ? ae.__h = [] : (t.__h.some(Yt), t.__h.some(Ko), Qt = 0), t.__h = [], t.__.some(function(n) {
    n.__N && (n.__ = n.__N), n.u = n.__N = void 0;
  })), Io = ae;
}, q.diffed = function(e) {
  ui && ui(e);
  var t = e.__c;
  t && t.__H && (t.__H.__h.length && mi(hi.push(t)), t.__H.__.some(function(n) {
    n.u && (n.__H = n.u);
  })), Io = ae = null;
}, q.__c = function(e, t) {
  t.some(function(n) {
    try {
      n.__h.some(Yt), n.__h = n.__h.filter(function(o) {
        return !o.__ || Ko(o);
      });
    } catch (o) {
      n.__h = [function() {
        throw o;
      }];
    }
  }), ci && ci(e, t);
}, q.unmount = function(e) {
  fi && fi(e);
  var t, n, o = e.__c;
  o && o.__H && (o.__H.__.some(function(r) {
    try {
      if (r.__P && r.__c) {
        if (n === void 0) {
          for (n = e.__; n && (!n.__c || !n.__c.__P); ) n = n.__;
          n = n && n.__c;
        }
        r.__P = n, mi(Ro.push(r));
      } else Yt(r);
    } catch (i) {
      t = i;
    }
  }), o.__H = void 0, t && q.__e(t, o.__v));
};
var di = typeof requestAnimationFrame == "function";
function gs(e) {
  var t, n = function() {
    clearTimeout(o), di && cancelAnimationFrame(t), setTimeout(e);
  }, o = setTimeout(n, 35);
  di && (t = requestAnimationFrame(n));
}
function mi(e) {
  e != 1 && ai == q.requestAnimationFrame || ((ai = q.requestAnimationFrame) || gs)(vs);
}
function Yt(e) {
  var t = ae, n = e.__c;
  typeof n == "function" && (e.__c = void 0, n()), ae = t;
}
function Ko(e) {
  var t = ae;
  e.__c = e.__(), ae = t;
}
function Ho(e, t) {
  return !e || e.length != t.length || t.some(function(n, o) {
    return !ms(n, e[o]);
  });
}

// node_modules/@preact/signals-core/dist/signals-core.module.js
var bs = /* @__PURE__ */ Symbol.for("preact-signals");
function Hn() {
  if (Ke > 1)
    Ke--;
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
      for (Zt = void 0, Rn++; n !== void 0; ) {
        var o = n.u;
        if (n.u = void 0, n.f &= -3, !(8 & n.f) && gi(n)) try {
          n.c();
        } catch (r) {
          t || (e = r, t = !0);
        }
        n = o;
      }
    }
    if (Rn = 0, Ke--, t) throw e;
  }
}
function Dn(e) {
  if (Ke > 0) return e();
  Do = ++ys, Ke++;
  try {
    return e();
  } finally {
    Hn();
  }
}
var Jt, D = void 0;
function se(e) {
  var t = D, n = Jt;
  D = void 0, Jt = void 0;
  try {
    return e();
  } finally {
    D = t, Jt = n;
  }
}
var Zt = void 0, Ke = 0, Rn = 0, ys = 0, Do = 0, Kn = void 0, On = 0;
function vi(e) {
  if (D !== void 0) {
    var t = e.n;
    if (t === void 0 || t.t !== D)
      return t = { i: 0, S: e, p: D.s, n: void 0, t: D, e: void 0, x: void 0, r: t }, D.s !== void 0 && (D.s.n = t), D.s = t, e.n = t, 32 & D.f && e.S(t), t;
    if (t.i === -1)
      return t.i = 0, t.n !== void 0 && (t.n.p = t.p, t.p !== void 0 && (t.p.n = t.n), t.p = D.s, t.n = void 0, D.s.n = t, D.s = t), t;
  }
}
function Q(e, t) {
  this.v = e, this.i = 0, this.n = void 0, this.t = void 0, this.l = 0, this.W = t?.watched, this.Z = t?.unwatched, this.name = t?.name;
}
Q.prototype.brand = bs;
Q.prototype.h = function() {
  return !0;
};
Q.prototype.S = function(e) {
  var t = this, n = this.t;
  n !== e && e.e === void 0 && (e.x = n, this.t = e, n !== void 0 ? n.e = e : se(function() {
    var o;
    (o = t.W) == null || o.call(t);
  }));
};
Q.prototype.U = function(e) {
  var t = this;
  if (this.t !== void 0) {
    var n = e.e, o = e.x;
    n !== void 0 && (n.x = o, e.e = void 0), o !== void 0 && (o.e = n, e.x = void 0), e === this.t && (this.t = o, o === void 0 && se(function() {
      var r;
      (r = t.Z) == null || r.call(t);
    }));
  }
};
Q.prototype.subscribe = function(e) {
  var t = this;
  return E(function() {
    var n = t.value;
    se(function() {
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
  return se(function() {
    return e.value;
  });
};
Object.defineProperty(Q.prototype, "value", { get: function() {
  var e = vi(this);
  return e !== void 0 && (e.i = this.i), this.v;
}, set: function(e) {
  if (e !== this.v) {
    if (Rn > 100) throw new Error("Cycle detected");
    (function(n) {
      Ke !== 0 && Rn === 0 && n.l !== Do && (n.l = Do, Kn = { S: n, v: n.v, i: n.i, o: Kn });
    })(this), this.v = e, this.i++, On++, Ke++;
    try {
      for (var t = this.t; t !== void 0; t = t.x) t.t.N();
    } finally {
      Hn();
    }
  }
} });
function g(e, t) {
  return new Q(e, t);
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
  Q.call(this, void 0, t), this.x = e, this.s = void 0, this.g = On - 1, this.f = 4;
}
rt.prototype = new Q();
rt.prototype.h = function() {
  if (this.f &= -3, 1 & this.f) return !1;
  if ((36 & this.f) == 32 || (this.f &= -5, this.g === On)) return !0;
  if (this.g = On, this.f |= 1, this.i > 0 && !gi(this))
    return this.f &= -2, !0;
  var e = D;
  try {
    bi(this), D = this;
    var t = this.x();
    (16 & this.f || this.v !== t || this.i === 0) && (this.v = t, this.f &= -17, this.i++);
  } catch (n) {
    this.v = n, this.f |= 16, this.i++;
  }
  return D = e, yi(this), this.f &= -2, !0;
};
rt.prototype.S = function(e) {
  if (this.t === void 0) {
    this.f |= 36;
    for (var t = this.s; t !== void 0; t = t.n) t.S.S(t);
  }
  Q.prototype.S.call(this, e);
};
rt.prototype.U = function(e) {
  if (this.t !== void 0 && (Q.prototype.U.call(this, e), this.t === void 0)) {
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
function U(e, t) {
  return new rt(e, t);
}
function _i(e) {
  var t = e.j;
  if (e.j = void 0, typeof t == "function") {
    Ke++;
    var n = D;
    D = void 0;
    try {
      t();
    } catch (o) {
      throw e.f &= -2, e.f |= 8, No(e), o;
    } finally {
      D = n, Hn();
    }
  }
}
function No(e) {
  for (var t = e.s; t !== void 0; t = t.n) t.S.U(t);
  e.x = void 0, e.s = void 0, _i(e);
}
function _s(e) {
  if (D !== this) throw new Error("Out-of-order effect");
  yi(this), D = e, this.f &= -2;
  try {
    8 & this.f && No(this);
  } finally {
    Hn();
  }
}
function wt(e, t) {
  this.x = e, this.j = void 0, this.s = void 0, this.u = void 0, this.f = 32, this.name = t?.name, Jt && Jt.push(this);
}
wt.prototype.c = function() {
  var e = this.S();
  try {
    if (8 & this.f || this.x === void 0) return;
    var t = this.x();
    typeof t == "function" && (this.j = t);
  } finally {
    e();
  }
};
wt.prototype.S = function() {
  if (1 & this.f) throw new Error("Cycle detected");
  this.f |= 1, this.f &= -9, _i(this), bi(this), Ke++;
  var e = D;
  return D = this, _s.bind(this, e);
};
wt.prototype.N = function() {
  2 & this.f || (this.f |= 2, this.u = Zt, Zt = this);
};
wt.prototype.d = function() {
  this.f |= 8, 1 & this.f || No(this);
};
wt.prototype.dispose = function() {
  this.d();
};
function E(e, t) {
  var n = new wt(e, t);
  try {
    n.c();
  } catch (r) {
    throw n.d(), r;
  }
  var o = n.d.bind(n);
  return o[Symbol.dispose] = o, o;
}

// node_modules/@preact/signals/dist/signals.module.js
var Fo, tn, Nn, ws = typeof window < "u" && !!window.__PREACT_SIGNALS_DEVTOOLS__, wi = [], ki = [];
E(function() {
  Fo = this.N;
})();
function kt(e, t) {
  C[e] = t.bind(null, C[e] || function() {
  });
}
function en(e) {
  if (Nn) {
    var t = Nn;
    Nn = void 0, t();
  }
  Nn = e && e.S();
}
function xi(e) {
  var t = this, n = e.data, o = it(n);
  o.name = "ReactiveDom", o.value = n;
  var r = An(function() {
    for (var s = t, p = t.__v; p = p.__; ) if (p.__c) {
      p.__c.__$f |= 4;
      break;
    }
    var c = U(function() {
      var f = o.value.value;
      return f === 0 ? 0 : f === !0 ? "" : f || "";
    }), u = U(function() {
      return !Array.isArray(c.value) && !Co(c.value);
    }), d = E(function() {
      if (this.N = Si, u.value) {
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
xi.displayName = "ReactiveTextNode";
Object.defineProperties(Q.prototype, { constructor: { configurable: !0, value: Jr(Y, null).constructor }, type: { configurable: !0, value: xi }, props: { configurable: !0, get: function() {
  var e = this;
  return { data: { get value() {
    return e.value;
  } } };
} }, __b: { configurable: !0, value: 1 } });
kt("__b", function(e, t) {
  if (en(), tn = void 0, typeof t.type == "string") {
    var n, o = t.props;
    for (var r in o) if (r !== "children") {
      var i = o[r];
      i instanceof Q && (n || (t.__np = n = {}), n[r] = i, o[r] = i.peek());
    }
  }
  e(t);
});
kt("__r", function(e, t) {
  if (e(t), t.type !== Y) {
    en();
    var n, o = t.__c;
    o && (o.__$f &= -2, (n = o.__$u) === void 0 && (o.__$u = n = (function(r, i) {
      var a;
      return E(function() {
        a = this;
      }, { name: i }), a.c = r, a;
    })(/* @__PURE__ */ (function(r) {
      return function() {
        var i;
        ws && ((i = this.y) == null || i.call(this)), r.__$f |= 1, r.setState({});
      };
    })(o), typeof t.type == "function" ? t.type.displayName || t.type.name : ""))), tn = o, en(n);
  }
});
kt("__e", function(e, t, n, o) {
  en(), tn = void 0, e(t, n, o);
});
kt("diffed", function(e, t) {
  en(), tn = void 0;
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
        c === void 0 ? (c = ks(n, p, u, r), i[p] = c) : c.o(u, r);
      }
    }
  }
  e(t);
});
function ks(e, t, n, o) {
  var r = t in e && e.ownerSVGElement === void 0, i = g(n);
  return { o: function(a, s) {
    i.value = a, o = s;
  }, d: E(function() {
    this.N = Si;
    var a = i.value.value;
    o[t] !== a && (o[t] = a, r ? e[t] = a : a != null && (a !== !1 || t[4] === "-") ? e.setAttribute(t, a) : e.removeAttribute(t));
  }) };
}
kt("unmount", function(e, t) {
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
kt("__h", function(e, t, n, o) {
  o < 3 && (t.__$f |= 2), e(t, n, o);
});
_t.prototype.shouldComponentUpdate = function(e, t) {
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
function it(e, t) {
  return An(function() {
    return g(e, t);
  }, []);
}
var xs = typeof requestAnimationFrame > "u" ? setTimeout : function(e) {
  var t = function() {
    clearTimeout(n), cancelAnimationFrame(o), e();
  }, n = setTimeout(t, 35), o = requestAnimationFrame(t);
}, Ss = function(e) {
  queueMicrotask(function() {
    queueMicrotask(e);
  });
};
function Ms() {
  Dn(function() {
    for (var e; e = wi.shift(); ) Fo.call(e);
  });
}
function Cs() {
  wi.push(this) === 1 && (C.requestAnimationFrame || xs)(Ms);
}
function Es() {
  Dn(function() {
    for (var e; e = ki.shift(); ) Fo.call(e);
  });
}
function Si() {
  ki.push(this) === 1 && (C.requestAnimationFrame || Ss)(Es);
}
function Mi(e, t) {
  var n = ne(e);
  n.current = e;
  var o = tn;
  Ee(function() {
    return E(function() {
      if (this.N = Cs, !(o && 8 & o.__$f)) return n.current();
    }, t);
  }, []);
}

// src/store.ts
var Fn = /* @__PURE__ */ new Set(), xt = (e) => typeof e == "object" && e !== null && !Array.isArray(e);
function rn(e, t) {
  if (!xt(e) || !xt(t)) return t;
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
    Fn.add(this), this.show();
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
    this.own.size === 0 && Fn.delete(this), n && this.show();
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
}, Te = class {
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
}, k = new Te(), N = new Te(), be = new Te(), St = new Te(), Mt = new Te(), Ct = new Te(), Oe = new Te(), at = new Te(), on = {
  lamps: k,
  groups: N,
  things: be,
  materials: St,
  views: Mt,
  looks: Ct,
  meters: Oe,
  grids: at
}, ee = g(null), an = g([]), xe = g([]), st = g({ undo: null, redo: null, steps: 0 }), lt = g({ state: "clean", file: "" }), W = g({ you: !0, name: null }), Pe = g(null), jn = new nn({
  ev: null,
  metered: !1,
  tone: "filmic",
  white: null,
  false_color: null
}), ut = jn.shown, jo = {
  scene: ee,
  layers: an,
  solo: xe,
  history: st,
  saved: lt,
  editor: W,
  status: Pe
};
function Ci(e) {
  Fn.clear();
  for (let [t, n] of Object.entries(on)) n.whole(e[t]);
  for (let [t, n] of Object.entries(jo)) t in e && (n.value = e[t]);
  xt(e.display) && jn.receive(e.display);
}
function Ei(e, t) {
  for (let [n, o] of Object.entries(e))
    n in on ? on[n].patch(o) : n === "display" ? jn.receive(o) : n in jo && (jo[n].value = o);
  Et(t);
}
function Et(e) {
  for (let t of [...Fn]) t.release(e);
}
function Ti(e, t) {
  for (let [n, o] of Object.entries(e))
    if (n in on && xt(o))
      for (let [r, i] of Object.entries(o)) {
        let a = on[n].entry(Number(r));
        a && xt(i) && t(a, i);
      }
    else n === "display" && xt(o) && t(jn, o);
}
var qo = (e, t) => Ti(e, (n, o) => n.keep(o, t)), qn = (e, t) => Ti(e, (n, o) => n.settle(o, t));
function He(e) {
  let t = N.get(e.group);
  return e.on && !e.parked && (t?.on ?? !0) ? e.level * (t?.level ?? 1) : 0;
}
var Pi = U(() => {
  let e = k.all();
  return e.length > 0 && e.every(([, t]) => He(t) === 0);
});
function Ts(e, t) {
  let n = t.trim().toLowerCase();
  return e.all().filter(([, o]) => !n || o.name.toLowerCase().includes(n));
}

// src/say.ts
var ct = g([]), Ps = 0;
function J(e, t = "plain") {
  if (ct.peek().find((r) => r.text === e)) return;
  let o = ++Ps;
  ct.value = [...ct.peek().slice(-2), { id: o, text: e, tone: t }], setTimeout(() => Uo(o), t === "warn" ? 8e3 : 4e3);
}
function Uo(e) {
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
}, $i = 0;
for (let e of ["input", "pointermove", "pointerdown", "keydown", "wheel"])
  addEventListener(e, (t) => $i = t.timeStamp, { capture: !0, passive: !0 });
function Li(e, t) {
  le.sent.push({ seq: e, what: t, at: performance.now(), input: $i }), le.sent.length > 1024 && le.sent.shift();
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
var B = g("entering"), un = g(0), de = g("edit"), Go = g(null), De = g(0), Ii = () => null, Ai = (e) => {
  Ii = e;
}, Un = /* @__PURE__ */ new Map(), Ge = null, sn = 0, Wo = null, ln = 0, Tt = "", Wn = !1;
function Se(e, t) {
  let n = Un.get(e) ?? /* @__PURE__ */ new Set();
  return Un.set(e, n.add(t)), () => n.delete(t);
}
function F(e) {
  return !Ge || Ge.readyState !== WebSocket.OPEN || B.peek() !== "open" ? 0 : (sn += 1, Ge.send(JSON.stringify({ ...e, seq: sn })), e.do !== "ack" && Li(sn, e.do), sn);
}
var $s = 0, ft = /* @__PURE__ */ new Map();
function Me(e, t, n, o = () => {
}) {
  let r = ++$s, i = Se("answer", (s) => {
    s.id === r && (s.done !== !1 && i(), n(s));
  }), a = F({ do: "ask", id: r, what: e, ...t });
  if (!a)
    return i(), o("There is no connection to the program."), i;
  ft.set(a, (s) => {
    i(), o(s);
  });
  for (let s of ft.keys()) {
    if (s > a - 300) break;
    ft.delete(s);
  }
  return i;
}
function Ls(e) {
  switch (e.is) {
    case "hello":
      if (ln = 0, Wo !== null && e.build !== Wo) {
        B.value = "renewed", Ge?.close();
        return;
      }
      Wo = e.build, de.value = e.role === "watch" ? "watch" : "edit", Go.value = e.you === void 0 ? null : String(e.you), De.value = 0, ft.clear(), B.value = "open";
      break;
    case "state":
      Ci(e.state ?? e);
      break;
    case "patch":
      Bo(e.seq), Ei(e.patch ?? {}, De.value);
      break;
    case "status":
      Pe.value = e;
      break;
    case "refused":
      if (Bo(e.seq), Et(De.value), ft.has(e.seq)) {
        ft.get(e.seq)?.(e.why ?? ""), ft.delete(e.seq);
        return;
      }
      break;
    case "event":
      e.what === "bye" && (Wn = !0);
      break;
  }
  for (let t of [...Un.get(e.is) ?? []]) t(e);
}
function Bo(e) {
  typeof e == "number" && e > De.value && (De.value = e);
}
async function Ri() {
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
function Ki() {
  let e = location.protocol === "https:" ? "wss" : "ws", t = new WebSocket(`${e}://${location.host}/wire`);
  t.binaryType = "arraybuffer";
  let n = !1;
  Ge = t, Un.get("line")?.forEach((o) => o({ is: "line" })), t.onmessage = (o) => {
    if (t !== Ge) return;
    if (typeof o.data != "string") {
      let i = Ii(o.data);
      i && Bo(i.seq);
      return;
    }
    let r = JSON.parse(o.data);
    r.is === "hello" && (n = !0, sn = 0), Ls(r);
  }, t.onclose = () => {
    t === Ge && (Ge = null, B.value !== "renewed" && Vs(n));
  };
}
async function Vs(e) {
  if (Et(1 / 0), !e && await Is()) {
    let o = await Ri();
    if (o === "denied" || o === "in" && ln > 4 && !Tt) {
      B.value = "denied";
      return;
    }
  }
  ln += 1;
  let t = /^(127\.|localhost$|\[::1\]$)/.test(location.hostname);
  ln > 3 && t && (Wn = !0), B.value = Wn ? "ended" : "lost";
  let n = Math.min(5, ln);
  for (let o = n; o > 0; o--)
    un.value = o, await new Promise((r) => setTimeout(r, 1e3));
  un.value = 0, Ki();
}
async function Is() {
  try {
    return (await fetch("/", { method: "HEAD", cache: "no-store" })).ok;
  } catch {
    return !1;
  }
}
async function Oi() {
  let e = location.hash.slice(1);
  if (e ? (Tt = e, sessionStorage.setItem("lampyris-key", Tt), window.history.replaceState(null, "", location.pathname + location.search)) : Tt = sessionStorage.getItem("lampyris-key") ?? "", le.entered = performance.now(), e && await Ri() === "denied") {
    B.value = "denied";
    return;
  }
  Ki();
}
Se("hello", () => Wn = !1);

// src/gesture.ts
var Pt = 0, Ni = /* @__PURE__ */ new Set(), Fi = (e) => {
  Ni.add(e);
}, cn = /* @__PURE__ */ new Set();
function Bn() {
  return B.value !== "open" ? "There is no connection to the program: nothing was changed." : de.value === "watch" ? "You are watching. Ask for the pen to change things." : W.value.you ? null : `${W.value.name ?? "Somebody else"} has the pen. Take it to change things.`;
}
var Hi = (e) => (e.length > 120 ? `${e.slice(0, 119)}…` : e).replace(/[\u0000-\u001f]/g, " "), Ne = class {
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
    this.state === "over" || !this.begin() || (qo(t, 1 / 0), this.touched = rn(this.touched, t), this.waiting = rn(this.waiting ?? {}, t), this.under <= De.peek() && this.flush());
  }
  /** Any other message that belongs to this step. */
  also(t) {
    this.state === "over" || !this.begin() || (this.flush(), this.last = F(t));
  }
  end(t) {
    this.state === "held" && (this.flush(), qn(this.touched, this.last), this.finish({ do: "end", ...t ? { label: Hi(t) } : {} })), this.state = "over";
  }
  cancel() {
    this.state === "held" && (this.waiting = null, qn(this.touched, 0), this.finish({ do: "cancel" }), Et(0)), this.state = "over";
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
    let t = se(Bn);
    return t ? (J(t, "warn"), this.state = "over", !1) : (this.state = "held", cn.add(this), Pt === 0 && Ni.forEach((n) => n()), Pt++ === 0 && (this.last = F({ do: "begin", label: Hi(this.label) })), !0);
  }
  flush() {
    this.waiting && (this.under = this.last = F({ do: "set", patch: this.waiting }), this.waiting = null);
  }
  finish(t) {
    cn.delete(this), Pt = Math.max(0, Pt - 1), Pt === 0 && F(t);
  }
};
function ue(e, t) {
  let n = new Ne(e);
  n.set(t), n.end();
}
function Gn(e, t) {
  let n = new Ne(e);
  n.also(t), n.end();
}
function $t(e) {
  se(() => B.value) === "open" && (qo({ display: e }, 1 / 0), qn({ display: e }, F({ do: "display", patch: e })));
}
var $e = null;
function zo(e, t, n) {
  $e && $e.key !== e && Di(), $e ??= { key: e, gesture: new Ne(t), timer: 0 }, $e.gesture.set(n), clearTimeout($e.timer), $e.timer = window.setTimeout(Di, 700);
}
function Di() {
  $e && (clearTimeout($e.timer), $e.gesture.end(), $e = null);
}
E(() => {
  De.value, se(() => [...cn].forEach((e) => e.followed()));
});
E(() => {
  B.value !== "open" && [...cn].forEach((e) => e.drop());
});

// src/vec.ts
var M = (e, t) => [e[0] + t[0], e[1] + t[1], e[2] + t[2]], A = (e, t) => [e[0] - t[0], e[1] - t[1], e[2] - t[2]], x = (e, t) => [e[0] * t, e[1] * t, e[2] * t], O = (e, t) => e[0] * t[0] + e[1] * t[1] + e[2] * t[2], ce = (e, t) => [
  e[1] * t[2] - e[2] * t[1],
  e[2] * t[0] - e[0] * t[2],
  e[0] * t[1] - e[1] * t[0]
], Fe = (e) => Math.hypot(e[0], e[1], e[2]), Ce = (e, t) => Fe(A(e, t)), As = (e, t, n) => M(x(e, 1 - n), x(t, n));
function j(e, t = [0, 0, 1]) {
  let n = Fe(e);
  return n > 1e-12 ? x(e, 1 / n) : t;
}
function pt(e) {
  let t = Math.abs(e[0]) < 0.7 * Fe(e) ? [1, 0, 0] : [0, 1, 0];
  return j(ce(t, e));
}
function fn(e, t, n) {
  let o = Math.cos(n), r = Math.sin(n);
  return M(M(x(e, o), x(ce(t, e), r)), x(t, O(t, e) * (1 - o)));
}
function Lt([e, t]) {
  return Array.from({ length: 8 }, (n, o) => [
    o & 1 ? t[0] : e[0],
    o & 2 ? t[1] : e[1],
    o & 4 ? t[2] : e[2]
  ]);
}
var ze = ([e, t]) => As(e, t, 0.5);

// src/camera.ts
var Xo = Math.PI / 180, zn = 89 * Xo;
function Vt(e, t, n) {
  let o = j(A(e.target, e.eye), [0, 0, -1]), r = j(ce(o, e.up), pt(o)), i = ce(r, o), a = e.height != null && e.height > 0, s = a ? e.height / n : 2 * Math.tan(e.fov * Xo * 0.5) / n;
  return { eye: e.eye, forward: o, side: r, up: i, width: t, height: n, pixel: s, parallel: a };
}
function pn(e, t) {
  let n = A(t, e.eye), o = O(n, e.forward), r = e.parallel ? e.pixel : e.pixel * o;
  return [e.width / 2 + O(n, e.side) / r, e.height / 2 - O(n, e.up) / r, o];
}
function Rs(e, t, n) {
  let o = (t - e.width / 2) * e.pixel, r = (e.height / 2 - n) * e.pixel, i = M(x(e.side, o), x(e.up, r));
  return e.parallel ? { origin: M(e.eye, i), direction: e.forward } : { origin: e.eye, direction: j(M(e.forward, i)) };
}
function ji(e, t, n, o) {
  let r = A(e.target, e.eye), i = Math.max(Fe(r), 1e-3), a = Math.asin(Math.max(-1, Math.min(1, O(j(r), t)))), s = A(r, x(t, O(r, t))), p = j(Fe(s) > 1e-6 * i ? s : A(e.up, x(t, O(e.up, t))), pt(t)), c = Math.max(-zn, Math.min(zn, a + o)), u = fn(p, t, n), d = M(x(u, Math.cos(c)), x(t, Math.sin(c)));
  return { ...e, up: t, target: M(e.eye, x(d, i)) };
}
function qi(e, t, n, o, r) {
  let i = A(e.target, e.eye), a = A(i, x(t, O(i, t))), s = j(Fe(a) > 1e-6 ? a : e.up, pt(t)), p = j(ce(s, t)), c = M(M(x(s, n), x(p, o)), x(t, r));
  return Xe(e, c);
}
function Ui(e, t, n, o, r) {
  let i = j(A(e.target, e.eye)), a = j(ce(i, e.up), pt(i));
  return Xe(e, M(M(x(i, n), x(a, o)), x(t, r)));
}
function Xe(e, t) {
  return { ...e, eye: M(e.eye, t), target: M(e.target, t) };
}
function Wi(e, t, n, o, r) {
  let i = j(A(e.target, e.eye)), a = Math.asin(Math.max(-1, Math.min(1, O(i, t)))), s = Math.max(-zn, Math.min(zn, a + r)), p = j(ce(i, t), j(ce(i, e.up), pt(i))), c = (u) => fn(fn(u, p, s - a), t, o);
  return {
    ...e,
    up: t,
    eye: M(n, c(A(e.eye, n))),
    target: M(n, c(A(e.target, n)))
  };
}
function Bi(e, t, n, o, r) {
  let i = t.parallel ? t.pixel : t.pixel * r;
  return Xe(e, M(x(t.side, -n * i), x(t.up, o * i)));
}
function Xn(e, t, n, o, r) {
  let i = A(t, e.eye), a = Fe(i);
  if (a < 1e-9) return e;
  let s = a * (1 - n);
  return r ? s = Math.sign(s) * Math.max(Math.abs(s), 0.5 * Math.abs(1 - n)) : s > 0 && (s = Math.max(0, Math.min(s, a - o))), Xe(e, x(i, s / a));
}
function Yn(e, t, n, o, r) {
  let i = Math.max(0.05, Math.min(1e5, (e.height ?? 1) * r)), a = (1 - i / (e.height ?? 1)) * t.pixel, s = M(
    x(t.side, (n - t.width / 2) * a),
    x(t.up, (t.height / 2 - o) * a)
  );
  return { ...Xe(e, s), height: i };
}
function Gi(e, t, n = 0.4) {
  let o = ze(t), r = Math.max(Ce(t[0], t[1]) / 2, 0.15), i = j(A(e.eye, e.target));
  if (e.height) {
    let s = O(A(e.eye, o), i);
    return { ...e, eye: M(o, x(i, s)), target: o, height: r * 3 };
  }
  let a = Math.max(1.5 * r / Math.tan(e.fov * Xo * 0.5), n + r);
  return { ...e, eye: M(o, x(i, a)), target: o };
}
var Ks = ["plan", "ceiling", "north", "east", "south", "west"];
function zi(e) {
  let t = Math.abs(e[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], n = j(ce(e, t));
  return { right: j(ce(n, e)), ahead: n };
}
function Xi(e, t, n, o) {
  let { right: r, ahead: i } = zi(n), a = ze(t), s = (_) => Math.abs(O(A(t[1], t[0]), _)), c = {
    plan: { forward: x(n, -1), up: i, side: r, cut: 0.15 },
    ceiling: { forward: n, up: x(i, -1), side: r, cut: 0.35 },
    north: { forward: i, up: n, side: r, cut: 0.25 },
    south: { forward: x(i, -1), up: n, side: r, cut: 0.25 },
    east: { forward: r, up: n, side: i, cut: 0.25 },
    west: { forward: x(r, -1), up: n, side: i, cut: 0.25 }
  }[e], u = s(c.forward), d = 1, m = A(a, x(c.forward, u / 2 + d)), f = 1.08 * Math.max(s(c.up), s(c.side) / o, 0.1);
  return { eye: m, target: a, up: c.up, fov: 50, height: f, near: d + u * c.cut };
}
function dn(e, t) {
  let n = (r, i) => Ce(r, i) < 1e-4, o = (r, i) => Math.abs((r ?? -1) - (i ?? -1)) < 1e-4;
  return n(e.eye, t.eye) && n(e.target, t.target) && n(e.up, t.up) && o(e.fov, t.fov) && o(e.height, t.height) && o(e.near, t.near);
}

// src/frames.ts
var G = g(null), At = g(0), Yi = ["moving", "settled", "final"], Qi = 32, It = /* @__PURE__ */ new Map(), Le = null, Yo = null, Qo = !1, dt = null;
function Os(e) {
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
function Hs(e) {
  let t = Os(e);
  return t ? (dt && F({ do: "ack", frame: dt.head.frame }), dt = { ...t, bytes: e, received: performance.now() }, Qo || Ds(), t.head) : null;
}
async function Ds() {
  for (Qo = !0; dt; ) {
    let { head: e, mime: t, bytes: n, received: o } = dt;
    dt = null;
    try {
      let r = await createImageBitmap(new Blob([new Uint8Array(n, Qi)], { type: t }));
      Ns(e, r, n.byteLength, o);
    } catch {
    }
    F({ do: "ack", frame: e.frame });
  }
  Qo = !1;
}
function Ns(e, t, n, o) {
  let r = performance.now();
  Le && Yo && ((Le.width !== t.width || Le.height !== t.height) && (Le.width = t.width, Le.height = t.height), Yo.drawImage(t, 0, 0)), t.close();
  let i = It.get(e.camera) ?? G.peek()?.camera;
  i && (G.value = { head: e, camera: i }), Fs(), Vi({
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
var Qn = [];
function Fs() {
  let e = performance.now();
  Qn = Qn.filter((t) => e - t < 1e3), Qn.push(e), At.value = Qn.length;
}
function Jo(e) {
  Le = e, Yo = e?.getContext("2d", { alpha: !1 }) ?? null;
}
function Ji() {
  if (!Le || !G.peek()) return null;
  let e = document.createElement("canvas");
  return e.width = Le.width, e.height = Le.height, e.getContext("2d", { alpha: !1 })?.drawImage(Le, 0, 0), e;
}
Ai(Hs);
Se("camera", (e) => {
  It.set(e.number, e);
  for (let t of It.keys()) {
    if (It.size <= 64) break;
    It.delete(t);
  }
});
Se("line", () => {
  It.clear(), dt = null;
});

// src/prefs.ts
var Zi = "lampyris-";
function fe(e, t) {
  let n = t;
  try {
    let r = localStorage.getItem(Zi + e);
    r !== null && (n = JSON.parse(r));
  } catch {
  }
  let o = g(n);
  return E(() => {
    let r = JSON.stringify(o.value);
    try {
      localStorage.setItem(Zi + e, r);
    } catch {
    }
  }), o;
}
var Zo = fe("theme", "dark"), er = fe("house-lights", 1), Jn = fe("hands", "default"), tr = fe("walking", "walk"), nr = fe("panels", !0), Rt = fe("listing", "faders"), Zn = fe("travel", "square"), Kt = fe("candles", "lx"), or = fe("single-keys", !0), rr = fe("lamp-marks", !0), js = fe("maintenance", 1), Ye = fe("fine", !1), ir = fe("fade", 1), qs = typeof matchMedia == "function" && matchMedia("(pointer: coarse)").matches, Ve = fe("look-only", qs);

// src/select.ts
var T = g(null), me = g(null), H = g(null), Us = g("move"), oe = U(() => {
  let e = T.value;
  return e?.kind === "lamp" ? e.ids.filter((t) => k.get(t)) : e?.kind === "group" ? e.ids.flatMap((t) => N.get(t)?.lamps ?? []) : [];
});
function Ie(e, t, n = "only") {
  let o = T.peek();
  if (n === "only" || o?.kind !== e) {
    T.value = { kind: e, ids: [t] };
    return;
  }
  let r = o.ids.includes(t);
  if (r && n === "add") return;
  let i = r ? o.ids.filter((a) => a !== t) : [...o.ids, t];
  T.value = i.length ? { kind: e, ids: i } : null;
}
function eo() {
  T.value = null;
}
function ea(e, t, n) {
  let o = T.peek(), r = o?.kind === e ? t.indexOf(o.ids[o.ids.length - 1]) : -1;
  if (r < 0) return Ie(e, n);
  let i = t.indexOf(n), [a, s] = r < i ? [r, i] : [i, r], p = t.slice(a, s + 1), c = (o?.ids ?? []).filter((u) => !p.includes(u));
  T.value = { kind: e, ids: [...c, ...r < i ? p : p.reverse()] };
}
function Ws(e) {
  let t = T.peek(), n = t?.kind ?? "lamp", o = n === "lamp" ? k.ids.peek() : n === "thing" ? be.ids.peek() : N.ids.peek();
  if (!o.length) return;
  let r = t ? o.indexOf(t.ids[t.ids.length - 1]) : e > 0 ? -1 : 0;
  Ie(n, o[(r + e + o.length) % o.length]);
}
function ta(e, t) {
  switch (e) {
    case "lamp":
      return k.get(t)?.name ?? `lamp ${t}`;
    case "group":
      return N.get(t)?.name ?? `group ${t}`;
    case "thing":
      return be.get(t)?.name ?? `thing ${t}`;
    case "material":
      return St.get(t)?.name ?? `material ${t}`;
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
    let i = k.get(e.lamp)?.group;
    i != null && (N.get(i)?.lamps.length ?? 0) > 1 && n.push({ kind: "group", ids: [i] });
  }
  if (e?.thing != null && n.push({ kind: "thing", ids: [e.thing] }), !n.length) {
    t === "only" && eo();
    return;
  }
  if (t !== "only") return Ie(n[0].kind, n[0].ids[0], t);
  let o = T.peek(), r = n.findIndex((i) => o?.kind === i.kind && o.ids.length === 1 && o.ids[0] === i.ids[0]);
  T.value = n[(r + 1) % n.length];
}
var to = g(null);

// src/navigate.ts
var Bs = 1.6, ye = g(null), ra = U(() => de.value === "edit" && W.value.you), he = U(() => ee.value?.up ?? [0, 0, 1]), _e = g([640, 480]), Dt = g(null), lr = null, mn = null, ar = !1, Je = [], cr = [], ur = 0;
function Z(e, t = null) {
  let n = ye.peek();
  if (n && dn(n, e)) return;
  let o = performance.now();
  n && (o - ur > 1e3 || t) && (Je.push(n), Je.length > 100 && Je.shift(), cr.length = 0), ur = o, ye.value = e, Dt.value = t;
}
var re = () => ye.peek();
function Gs() {
  ia(Je, cr);
}
function zs() {
  ia(cr, Je);
}
function ia(e, t) {
  let n = e.pop();
  if (!n) return;
  let o = ye.peek();
  o && t.push(o), ur = performance.now(), ye.value = n, Dt.value = null;
}
E(() => {
  !ye.value || B.value !== "open" || !ra.value || ar || (ar = !0, requestAnimationFrame(() => {
    ar = !1;
    let t = ye.peek();
    if (!t || mn && dn(mn, t)) return;
    let { eye: n, target: o, up: r, fov: i, height: a, near: s } = t, p = { do: "camera", eye: n, target: o, up: r, fov: i };
    a && (p.height = a), s && (p.near = s), F(p) && (mn = t);
  }));
});
E(() => {
  let e = G.value;
  e && se(() => {
    ye.peek() && ra.peek() || (mn = e.camera, ye.value = e.camera, lr ??= e.camera);
  });
});
Se("hello", () => mn = null);
function Nt(e, t) {
  let n = G.peek();
  if (!n) return null;
  let { head: o } = n, r = hn(o.width, o.height);
  return { frame: o.frame, x: (e - r.x) / r.scale, y: (t - r.y) / r.scale };
}
function hn(e, t) {
  let [n, o] = _e.peek(), r = Math.min(n / e, o / t);
  return { x: (n - e * r) / 2, y: (o - t * r) / 2, scale: r };
}
function mt(e = ye.peek()) {
  let [t, n] = _e.peek();
  return e ? Vt(e, t, n) : null;
}
var Ht = () => ee.peek()?.bounds ?? [[0, 0, 0], [1, 1, 1]], Ft = () => ze(Ht());
function no(e, t) {
  let n = re();
  n && Z(ji(n, he.peek(), e, t));
}
function oo(e, t, n) {
  let o = re();
  o && Z(Wi(o, he.peek(), e, t, n));
}
function jt(e, t, n) {
  let o = re(), r = mt();
  o && r && Z(Bi(o, r, e, t, n));
}
function aa(e, t, n) {
  let o = re();
  if (o) {
    if (o.height) {
      let r = mt(o);
      r && Z(Xe(o, M(x(r.side, t), x(r.up, e))));
      return;
    }
    tr.peek() === "fly" || n !== 0 ? Z(Ui(o, he.peek(), e, t, n)) : (Z(qi(o, he.peek(), e, t, 0)), Xs());
  }
}
var Ot = !1, sr = !0, oa = null;
function Xs() {
  let e = re();
  if (!e || Ot || !sr) return;
  let t = he.peek();
  Ot = !0;
  let n = Me("ray", { origin: e.eye, direction: x(t, -1) }, (o) => {
    Ot = !1, sr = !0;
    let r = re();
    if (!o.hit || !r || r.height) return;
    oa = O(o.point, t);
    let i = oa + Bs - O(r.eye, t);
    Math.abs(i) > 0.01 && Z(Xe(r, x(t, i * 0.5)));
  }, () => {
    Ot = !1, sr = !1;
  });
  setTimeout(() => {
    Ot && n(), Ot = !1;
  }, 500);
}
function Ys() {
  let e = T.peek();
  if (!e) return null;
  let t = [], n = (i, a) => {
    i ? t.push(i) : a && t.push([a, a]);
  };
  for (let i of e.ids)
    if (e.kind === "lamp" && n(k.get(i)?.box, k.get(i)?.place?.position), e.kind === "thing" && n(be.get(i)?.box), e.kind === "meter" && n(null, Oe.get(i)?.point), e.kind === "group")
      for (let a of N.get(i)?.lamps ?? []) n(k.get(a)?.box, k.get(a)?.place?.position);
  if (!t.length) return null;
  let o = t.flatMap(Lt), r = (i) => [0, 1, 2].map((a) => i(...o.map((s) => s[a])));
  return [r(Math.min), r(Math.max)];
}
function fr() {
  let e = re(), t = Ys();
  e && t ? Z(Gi(e, t), "selection") : pr();
}
function pr() {
  lr && Z(lr, "home");
}
function Qs(e) {
  let [t, n] = _e.peek();
  Z(Xi(e, Ht(), he.peek(), t / n), e);
}
function Js() {
  for (let e = Je.length - 1; e >= 0; e--)
    if (!Je[e].height) return Z(Je[e], "inside");
  pr();
}
var Zs = U(() => {
  let e = ye.value;
  if (!e?.height) return null;
  let t = Vt(e, 2, 2), n = Lt(Ht()).map((s) => O(A(s, e.eye), t.forward)), o = e.near ?? 0, r = O(t.forward, he.value), i = Math.min(...Lt(Ht()).map((s) => O(s, he.value))), a = Math.abs(r) > 0.99 ? O(e.eye, he.value) + r * o - i : null;
  return { value: o, most: Math.max(...n), height: a };
});
function el(e) {
  let t = re();
  t && (ye.value = { ...t, near: Math.max(0, e) });
}

// src/tools.ts
var ro = g("spot"), vn = null;
function dr(e) {
  vn = null, H.value = H.peek() === e ? null : e;
}
function la(e) {
  if (!e) return J("There is nothing at that point.", "warn");
  switch (H.peek()) {
    case "aim":
      ua(oe.peek(), e.point), H.value = null;
      break;
    case "meter":
      ca(e.point, e.normal), H.value = null;
      break;
    case "grid":
      if (!vn) {
        vn = e;
        return;
      }
      tl(vn.point, e.point), vn = null, H.value = null;
      break;
    case "add":
      nl(ro.peek(), e), H.value = null;
      break;
  }
}
function ua(e, t) {
  let n = {};
  for (let o of e) {
    let r = k.get(o)?.place;
    !r?.position || !r.direction || (n[o] = { place: { aim: t, direction: j(A(t, r.position)) } });
  }
  if (!Object.keys(n).length) return J("What is selected shines into all directions: it cannot be aimed.", "warn");
  ue(`Aim ${Qe(e)}`, { lamps: n });
}
function mr(e, t) {
  let n = new Set(e.ids.peek()), o = e.ids.subscribe((r) => {
    let i = r.filter((a) => !n.has(a));
    i.length && (Ie(t, i[i.length - 1]), queueMicrotask(() => o()));
  });
  setTimeout(() => o(), 3e3);
}
var gn = (e) => Math.max(-1, ...e.ids.peek()) + 1;
function ca(e, t) {
  let n = gn(Oe);
  mr(Oe, "meter"), ue("Lay a meter", { meters: { [n]: { name: `Meter ${n + 1}`, kind: "surface", point: e, normal: t } } });
}
function fa(e) {
  return Math.min(10, 0.2 * 5 ** Math.log10(Math.max(e, 0.01)));
}
function tl(e, t, n = { lux: 500, uniformity: 0.6 }) {
  let o = he.peek(), r = Math.abs(o[0]) > 0.9 ? [0, 1, 0] : [1, 0, 0], i = j(ce(o, r)), a = A(t, e), [s, p] = [O(a, r), O(a, i)];
  if (Math.abs(s) < 0.05 || Math.abs(p) < 0.05) return J("An area needs two corners that lie apart.", "warn");
  let c = M(e, M(x(r, Math.min(s, 0)), x(i, Math.min(p, 0))));
  [s, p] = [Math.abs(s), Math.abs(p)];
  let u = (m) => Math.max(1, Math.ceil(m / fa(Math.max(s, p)))), d = gn(at);
  mr(at, "grid"), ue("Lay a grid", {
    grids: {
      [d]: {
        name: `Area ${d + 1}`,
        corner: c,
        u: x(r, s),
        v: x(i, p),
        normal: o,
        columns: u(s),
        rows: u(p),
        target: n
      }
    }
  });
}
var sa = { point: "Point", spot: "Spot", disc: "Area", sphere: "Sphere" };
function nl(e, t) {
  let n = he.peek(), o = O(t.normal, n), r = o > 0.7 ? M(t.point, x(n, 1.2)) : M(t.point, x(t.normal, 0.15)), i = o > 0.7 || o < -0.7 ? x(n, -1) : t.normal, a = { position: r };
  e !== "point" && e !== "sphere" && (a.direction = i), e === "spot" && Object.assign(a, { inner: 24, outer: 36, ...o > 0.7 ? { aim: t.point } : {} }), e === "disc" && (a.radius = 0.15), e === "sphere" && (a.radius = 0.08);
  let s = k.all().filter(([, p]) => p.own).length;
  mr(k, "lamp"), Gn(`Add ${sa[e]?.toLowerCase() ?? e} lamp`, {
    do: "add",
    lamp: { name: `${sa[e] ?? e} ${s + 1}`, kind: e, flux: 800, place: a }
  });
}
function ol(e, t, n) {
  !e.length || t < 1 || Gn(`Copy ${Qe(e)}`, { do: "copy", lamps: e, count: t, step: n });
}
function rl(e) {
  e.length && Gn(`Remove ${Qe(e)}`, { do: "remove", lamps: e });
}
function il(e, t, n) {
  let o = {};
  for (let r of e) {
    let i = k.get(r)?.place, a = n.get(r);
    if (!a) continue;
    let s = M(a, t), p = i?.aim && Ce(i.aim, s) > 1e-6 ? { direction: j(A(i.aim, s)) } : {};
    o[r] = { place: { position: s, ...p } };
  }
  return { lamps: o };
}
function io(e) {
  return e.kind === "sky" || e.kind === "parallel" ? null : e.place?.position ?? (e.box ? ze(e.box) : null);
}
function al(e) {
  let t = /* @__PURE__ */ new Map();
  for (let n of e) {
    let o = k.get(n), r = o && io(o);
    r && t.set(n, r);
  }
  return t;
}

// src/actions.ts
var ht = g(null), Ae = g("lamps"), vr = g("");
function so(e) {
  let t = Bn();
  t ? J(t, "warn") : F(e);
}
var sl = (e, t) => Object.fromEntries(e.map((n) => [n, t])), ll = {
  quantity: "illuminance",
  low: 1,
  high: 1e3,
  scale: "log",
  palette: "viridis",
  lines: !1
}, hr = ll, ul = () => ut.peek().false_color ?? hr;
function gr() {
  let e = ut.peek().false_color;
  e && (hr = e), $t({ false_color: e ? null : hr });
}
function lo(e) {
  let t = Math.round(((ut.peek().ev ?? 0) + e / 3) * 30) / 30;
  $t({ ev: t });
}
function cl() {
  let e = re();
  if (!e) return;
  let t = gn(Mt);
  ue("Store the view", { views: { [t]: { ...e, name: `View ${t + 1}` } } });
}
var fl = () => so({ do: "look", what: "store", name: `Look ${gn(Ct) + 1}` });
async function br(e) {
  let t = !1;
  try {
    await navigator.clipboard.writeText(e), t = !0;
  } catch {
    let n = document.createElement("textarea");
    n.value = e, n.className = "spoken", document.body.append(n), n.select(), t = document.execCommand("copy"), n.remove();
  }
  J(t ? "Copied." : `Copy it by hand: ${e}`);
}
var qt = /* @__PURE__ */ new Map(), ao = null;
function pl(e) {
  qt = new Map(e.map((t) => [t.id, t])), ao && ie(ao), ao = null;
}
var dl = () => [...qt.values()], pa = (e) => qt.get(e), yr = (e) => qt.get(e)?.why?.() ?? null;
function ie(e) {
  let t = qt.get(e);
  qt.size || (ao = e);
  let n = t?.why?.();
  n ? J(n, "warn") : t?.run();
}

// src/before.ts
var bn = g(null), ve = g(null), ml = g(0.5);
function hl() {
  let e = G.peek(), t = Ji();
  e && t && (bn.value = { picture: t, camera: e.camera });
}
Fi(() => {
  ve.peek() !== "wipe" && hl();
});
function da() {
  let e = bn.peek(), t = G.peek();
  if (!e || !t) J("Nothing has been changed yet.");
  else if (!dn(e.camera, t.camera)) J("The picture before was taken from another place: go back there with Alt+←.", "warn");
  else return !0;
  return !1;
}
function yn(e) {
  e ? ve.peek() === null && da() && (ve.value = "held") : ve.peek() === "held" && (ve.value = null);
}
function vl() {
  ve.value = ve.peek() === "wipe" ? null : da() ? "wipe" : null;
}

// node_modules/preact/jsx-runtime/dist/jsxRuntime.mjs
var gl = /* @__PURE__ */ Symbol.for("pv"), bl = 0;
function l(e, t, n, o, r, i) {
  t || (t = {});
  var a, s, p = t;
  if ("ref" in p && typeof e != "function") for (s in p = {}, t) s == "ref" ? a = t[s] : p[s] = t[s];
  var c = { type: e, props: p, key: n, ref: a, __k: null, __: null, __b: 0, __e: null, __c: null, constructor: gl, __v: --bl, __i: -1, __u: 0 };
  return (r || i) && (c.__source = r, c.__self = i), C.vnode && C.vnode(c), c;
}

// src/load.tsx
var ha = g(null), ma = !1, _r = (e) => ha.value?.[e];
function te({ part: e }) {
  let t = _r(e);
  return t ? l(t, {}) : null;
}
function va() {
  E(() => {
    if (ma || !(G.value ?? T.value)) return;
    ma = !0;
    let e = "./gizmo.js";
    setTimeout(() => {
      import(e).then((t) => ha.value = t);
    }, 0);
  });
}

// src/units.ts
var uo = 0.3048, ga = {
  level: { bare: 0.01, units: { "%": 0.01, x: 1, "×": 1 }, low: 0, high: 1e3, say: "a level such as 80 % or 450 lm" },
  flux: { bare: 1, units: { lm: 1, klm: 1e3 }, low: 0, high: 1e9, say: "a flux such as 450 lm" },
  kelvin: { bare: 1, units: { k: 1 }, low: 1e3, high: 25e3, say: "a colour temperature such as 2700 K" },
  angle: { bare: 1, units: { "°": 1, deg: 1, rad: 180 / Math.PI }, low: -36e3, high: 36e3, say: "an angle such as 30°" },
  length: {
    bare: 1,
    units: { m: 1, cm: 0.01, mm: 1e-3, km: 1e3, ft: uo, "'": uo, in: uo / 12, '"': uo / 12 },
    low: -1e6,
    high: 1e6,
    say: `a length such as 2.4 m, 75 cm or 8'2"`
  },
  lux: { bare: 1, units: { lx: 1, klx: 1e3, fc: 10.7639 }, low: 0, high: 1e9, say: "an illuminance such as 500 lx" },
  share: { bare: 1, units: { "%": 0.01 }, low: 0, high: 1, say: "a share from 0 to 1 or 0 to 100 %" },
  number: { bare: 1, units: {}, low: -1e9, high: 1e9, say: "a number" },
  ev: { bare: 1, units: { ev: 1, stop: 1, stops: 1 }, low: -30, high: 30, say: "an exposure such as 8.3" },
  seconds: { bare: 1, units: { s: 1, ms: 1e-3, min: 60 }, low: 0, high: 3600, say: "a time such as 2 s" }
}, yl = /^[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:\/(?:\d+(?:\.\d*)?|\.\d+))?/;
function wr(e) {
  let t = yl.exec(e);
  if (!t) return null;
  let [n, o] = t[0].split("/").map(Number);
  return o === 0 ? null : { value: o === void 0 ? n : n / o, rest: e.slice(t[0].length).trimStart() };
}
function ba(e, t, n) {
  let o = e.trim(), r = 0, i = !0;
  for (; o; ) {
    let a = 1, s = /^[+-]\s*/.exec(o);
    s && !i && (a = o[0] === "-" ? -1 : 1, o = o.slice(s[0].length));
    let p = wr(o);
    if (!p) return null;
    let c = /^[a-zµ°%'"×]+/i.exec(p.rest)?.[0] ?? "", u = c === "" ? n : t.units[c.toLowerCase()];
    if (u === void 0) return null;
    r += a * p.value * u, o = p.rest.slice(c.length).trim(), i = !1;
  }
  return i ? null : r;
}
function ya(e, t, n) {
  let o = ga[t], r = e.trim().replace(/,(?=\d)/g, ".").replace(/[\u2009\u202f\u00a0]/g, "").replace(/−/g, "-"), i = { why: `“${e.trim()}” is not ${o.say}` }, a = (w) => ({
    apply: (S) => Math.min(o.high, Math.max(o.low, w(S)))
  });
  if (!r) return { why: `Type ${o.say}` };
  let s = r.toLowerCase();
  if (t === "level" && s === "full") return a(() => 1);
  if (t === "level" && (s === "out" || s === "off")) return a(() => 0);
  let p = /^(.*?)\s*(?:stops?|ev)$/i.exec(r);
  if (p && t !== "ev") {
    let w = wr(p[1].trim());
    return !w || w.rest || !["level", "flux", "lux", "number"].includes(t) ? i : a((S) => S * 2 ** w.value);
  }
  let c = /^([*/×÷])\s*(.+)$/.exec(r);
  if (c) {
    let w = wr(c[2]);
    if (!w) return i;
    let S = w.rest === "%" ? 0.01 : w.rest === "" ? 1 : NaN, y = w.value * S;
    return !Number.isFinite(y) || y === 0 && /[/÷]/.test(c[1]) ? i : a((b) => /[/÷]/.test(c[1]) ? b / y : b * y);
  }
  let d = t === "length" || t === "angle" || t === "ev" || t === "number" ? /^([+-])=\s*(.+)$/.exec(r) : /^([+-])=?\s*(.+)$/.exec(r), m = d ? d[2] : r, f = ba(m, o, o.bare);
  if (f === null && t === "level" && n) {
    let w = ba(m, { ...ga.flux }, NaN);
    f = w === null || Number.isNaN(w) ? null : w / n;
  }
  if (f === null || !Number.isFinite(f)) return i;
  let _ = f;
  return d ? a((w) => d[1] === "-" ? w - _ : w + _) : _ < o.low || _ > o.high ? { why: `${e.trim()} is out of range: ${o.say}` } : a(() => _);
}
function z(e, t = 0) {
  if (!Number.isFinite(e)) return "–";
  let [n, o] = Math.abs(e).toFixed(t).split("."), r = n.length > 4 ? n.replace(/\B(?=(\d{3})+$)/g, " ") : n;
  return (e < 0 && Number(Math.abs(e).toFixed(t)) !== 0 ? "−" : "") + r + (o ? `.${o}` : "");
}
function Ze(e) {
  let t = Math.abs(e);
  return z(e, t >= 99.95 || t === 0 ? 0 : t >= 9.995 ? 1 : t >= 0.9995 ? 2 : 3);
}
function Re(e) {
  let t = e * 100;
  return z(t, t >= 9.95 || t === 0 ? 0 : t >= 0.95 ? 1 : 2);
}
function _n(e, t) {
  switch (t) {
    case "level":
      return `${Re(e)} %`;
    case "flux":
      return `${Ze(e)} lm`;
    case "kelvin":
      return `${z(e)} K`;
    case "angle":
      return `${z(e, 1)}°`;
    case "length":
      return `${z(e, 2)} m`;
    case "lux":
      return `${Ze(e)} lx`;
    case "seconds":
      return `${z(e, 1)} s`;
    case "ev":
      return z(e, 1);
    case "share":
      return z(e, 2);
    case "number":
      return String(Math.round(e * 1e4) / 1e4);
  }
}
function vt(e, t = !0) {
  let n = Kt.value === "fc", o = n ? e / 10.7639 : e;
  return Ze(o) + (t ? n ? " fc" : " lx" : "");
}

// src/field.tsx
function wn(e) {
  let t = it(null), n = it(null), o = ne(null), r = ne(null), i = t.value ?? e.text ?? (e.value === null ? "mixed" : _n(e.value, e.quantity));
  Ee(() => {
    !e.open || !o.current || (t.value = e.open, o.current.focus(), o.current.setSelectionRange(e.open.length, e.open.length), e.opened?.());
  }, [e.open]);
  let a = () => {
    if (t.value === null) return;
    let d = ya(t.value, e.quantity, e.flux);
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
function X({ name: e }) {
  return l("svg", { class: "sign", "aria-hidden": "true", width: "16", height: "16", children: l("use", { href: `icons.svg#${e}` }) });
}

// src/menu.tsx
function Ut({ id: e, label: t, title: n, children: o }) {
  let r = (a) => {
    let s = document.getElementById(e), p = a.getBoundingClientRect();
    s?.style.setProperty("left", `${Math.max(8, Math.min(p.left, innerWidth - 296))}px`), s?.style.setProperty("top", `${p.bottom + 4}px`);
  };
  return l(Y, { children: [
    l("button", { ...{ popovertarget: e }, title: n, "aria-label": n, "aria-haspopup": "true", onPointerDown: (a) => r(a.currentTarget), onFocus: (a) => r(a.currentTarget), children: t }),
    l("div", { id: e, popover: "auto", class: "menu", children: o })
  ] });
}
function kr({ id: e, label: t }) {
  let n = yr(e), o = pa(e);
  return l(
    "button",
    {
      class: "item",
      "aria-disabled": n !== null,
      title: n ?? void 0,
      onClick: (r) => {
        r.currentTarget.closest("[popover]")?.hidePopover(), ie(e);
      },
      children: [
        l("span", { children: t ?? o?.label }),
        l("kbd", { children: o?.keys })
      ]
    }
  );
}

// src/bar.tsx
var _a = {
  clean: "nothing changed",
  saved: "saved",
  waiting: "saving…",
  failed: "not saved"
};
function wa() {
  let e = ut.value, t = st.value.undo, n = st.value.redo, o = lt.value, r = e.metered;
  return l("header", { class: "bar", children: [
    l(Ut, { id: "page-menu", label: l(X, { name: "menu" }), title: "Page", children: l(te, { part: "PageItems" }) }),
    l("h1", { title: o.file || ee.value?.file, children: [
      ee.value?.name ?? "Lampyris",
      l("i", { class: `dot ${o.state}`, role: "img", "aria-label": _a[o.state], title: `${_a[o.state]}${o.file ? `: ${o.file}` : ""}` })
    ] }),
    l("span", { class: "group", children: [
      l("button", { class: "icon", "aria-label": t ? `Undo: ${t}` : "Undo", title: t ? `Undo: ${t} (Ctrl+Z)` : "Nothing to undo", "aria-disabled": t === null, onClick: () => ie("undo"), children: l(X, { name: "undo" }) }),
      l("button", { class: "icon", "aria-label": n ? `Redo: ${n}` : "Redo", title: n ? `Redo: ${n} (Ctrl+Shift+Z)` : "Nothing to redo", "aria-disabled": n === null, onClick: () => ie("redo"), children: l(X, { name: "redo" }) })
    ] }),
    l(Ut, { id: "view-menu", label: l(Y, { children: [
      "View ",
      l(X, { name: "down" })
    ] }), title: "View", children: l(te, { part: "ViewItems" }) }),
    l("span", { class: "group wide", children: [
      l("button", { "aria-pressed": !1, onClick: () => ie("preset-plan"), title: "Plan (Shift+1)", children: "Plan" }),
      l("button", { onClick: () => ie("inside"), title: "Inside (Shift+0)", children: "Inside" })
    ] }),
    l("span", { class: "gap" }),
    l(Ut, { id: "seeing-menu", label: l(Y, { children: [
      "Picture ",
      l(X, { name: "down" })
    ] }), title: "Picture: tone, white, figures", children: l(te, { part: "SeeingItems" }) }),
    l("button", { "aria-pressed": e.false_color !== null, onClick: gr, title: "False colour (B)", children: "False colour" }),
    l("button", { "aria-pressed": ve.value === "wipe", "aria-disabled": bn.value === null, onClick: () => ie("wipe"), title: "Wipe between before and now (C); hold \\ to see before", children: "Compare" }),
    l("span", { class: "group exposure", role: "group", "aria-label": "Exposure", children: [
      l("button", { class: "icon", "aria-label": "Darker", title: "Darker by ⅓ (,)", onClick: () => lo(1), children: l(X, { name: "minus" }) }),
      l("label", { children: [
        l("span", { "aria-hidden": "true", children: "EV" }),
        l(wn, { label: "Exposure value", quantity: "ev", value: e.ev ?? 0, step: 1 / 3, set: (i) => $t({ ev: i(e.ev ?? 0) }) })
      ] }),
      l("button", { class: "icon", "aria-label": "Brighter", title: "Brighter by ⅓ (.)", onClick: () => lo(-1), children: l(X, { name: "plus" }) }),
      l("button", { class: "icon", "aria-label": "Meter once", title: `${r ? "As metered" : "Meter once"} (/); it stays locked`, onClick: () => F({ do: "expose" }), children: l(X, { name: r ? "lock" : "meter" }) })
    ] }),
    l(
      "button",
      {
        class: "icon look-lock",
        "aria-pressed": Ve.value,
        "aria-label": "Look-only lock",
        title: "Look-only lock: no finger changes anything",
        onClick: () => Ve.value = !Ve.value,
        children: l(X, { name: Ve.value ? "lock" : "unlock" })
      }
    ),
    de.value === "edit" && l("button", { class: "wide", onClick: () => ht.value = "share", children: "Share" }),
    l("button", { class: "icon", "aria-label": "All keys", title: "All keys (?)", onClick: () => ht.value = "help", children: l(X, { name: "help" }) }),
    l("button", { class: "icon", "aria-label": "Command palette", title: "Command palette (Ctrl+K)", onClick: () => ht.value = "palette", children: l(X, { name: "search" }) }),
    l(
      "button",
      {
        class: "icon narrow",
        "aria-label": Ae.value === "inspector" ? "Lamps" : "Inspector",
        title: Ae.value === "inspector" ? "Lamps" : "Inspector",
        onClick: () => Ae.value = Ae.value === "inspector" ? "lamps" : "inspector",
        children: l(X, { name: Ae.value === "inspector" ? "lamps" : "sliders" })
      }
    )
  ] });
}

// src/highlight.ts
function co(e) {
  xe.value = e, F({ do: "solo", lamps: e });
}
function xr(e) {
  let t = xe.peek(), n = e.every((o) => t.includes(o));
  co(n ? t.filter((o) => !e.includes(o)) : [...t, ...e.filter((o) => !t.includes(o))]);
}
var _l = () => xr(oe.peek()), Sr = () => co([]), kn = null;
function fo(e) {
  e && kn === null && oe.peek().length ? (kn = xe.peek(), co(oe.peek())) : !e && kn !== null && (co(kn), kn = null);
}

// src/lights.ts
var et = g(null), Mr = () => {
}, xa = () => {
};
function po(e, t, n) {
  mo(), et.value = { x: e, y: t, hit: n, lux: n.lux, lamps: [], done: !1 }, ka(n);
  let o = !0, r = 0;
  xa = E(() => {
    for (let [, i] of k.all()) He(i);
    if (o) {
      o = !1;
      return;
    }
    clearTimeout(r), r = window.setTimeout(() => {
      let i = se(() => et.value);
      i && ka(i.hit);
    }, 250);
  });
}
function ka(e) {
  Mr(), Mr = Me("light", { point: e.point, normal: e.normal }, (t) => {
    let n = et.peek();
    n && (et.value = {
      ...n,
      lux: t.lux ?? n.lux,
      lamps: t.lamps ?? n.lamps,
      done: t.done !== !1
    });
  });
}
function mo() {
  Mr(), xa(), et.value = null;
}

// src/keys.ts
var $a = g("W A S D"), Cr = {
  KeyW: [1, 0, 0],
  KeyS: [-1, 0, 0],
  KeyA: [0, -1, 0],
  KeyD: [0, 1, 0],
  KeyQ: [0, 0, -1],
  KeyE: [0, 0, 1]
}, wl = 1.8, Wt = /* @__PURE__ */ new Set(), ho = !1, vo = 1, Er = !1, Tr = 0;
function La(e) {
  let t = Math.min(0.1, Math.max(0, (e - Tr) / 1e3));
  if (Tr = e, !Wt.size) {
    Er = !1;
    return;
  }
  let [n, o, r] = [0, 0, 0];
  for (let s of Wt) {
    let [p, c, u] = Cr[s];
    n += p, o += c, r += u;
  }
  let i = Math.max(1, Ce(...Ht()) / 12), a = wl * t * vo * Math.min(i, 6);
  (n || o || r) && aa(n * a, o * a, r * a), requestAnimationFrame(La);
}
function xn(e) {
  Wt.add(e), !Er && (Er = !0, Tr = performance.now(), requestAnimationFrame(La));
}
var kl = (e) => e instanceof HTMLElement && (e.isContentEditable || e.matches("input, textarea, select") && !e.matches("[type=range], [type=checkbox], [type=radio]"));
function Sa() {
  let e = document.activeElement;
  return e === null || e === document.body || e.id === "view";
}
var xl = {
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
}, Ma = {
  b: "quantity",
  o: "park",
  i: "unsolo",
  l: "from-lamp",
  g: "grid",
  t: "aim-here"
}, Ca = { Comma: "darker", Period: "brighter", Slash: "expose" }, Ea = {
  Digit1: "preset-plan",
  Digit2: "preset-ceiling",
  Digit3: "preset-north",
  Digit4: "preset-east",
  Digit5: "preset-south",
  Digit6: "preset-west",
  Digit0: "inside"
};
function Sl(e) {
  let t = e.key.toLowerCase();
  return t === "z" ? e.shiftKey ? "redo" : "undo" : t === "y" ? "redo" : t === "k" ? "palette" : t === "s" ? e.shiftKey ? "picture" : "save" : t === "d" ? "duplicate" : t === "a" ? "all-lamps" : t === "enter" ? "look-store" : null;
}
function Ml() {
  H.peek() ? H.value = null : et.peek() ? mo() : ve.peek() ? ve.value = null : T.peek() ? eo() : document.activeElement?.id === "view" && document.querySelector('.bar button, .bar [tabindex="0"]')?.focus();
}
function Ta(e) {
  let [t, n] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key] ?? [0, 0];
  return !t && !n ? !1 : (e.ctrlKey || re()?.height ? jt(-t * 24, n * 24, 3) : e.shiftKey ? oo(Ft(), -t * 0.05, n * 0.05) : no(-t * 0.06, n * 0.06), !0);
}
function Pa(e) {
  let t = re(), n = mt();
  !t || !n || (t.height ? Z(Yn(t, n, n.width / 2, n.height / 2, e)) : Z(Xn(t, t.target, e, 0.3, !0)));
}
function Cl(e) {
  if (e.defaultPrevented || document.querySelector("dialog[open]")) return;
  let t = e.ctrlKey || e.metaKey;
  if (e.key === "Escape") return Ml();
  if (kl(e.target)) {
    t && e.key.toLowerCase() === "k" && je(e, "palette");
    return;
  }
  if (t && !e.altKey) {
    if (Sa() && Ta(e)) return e.preventDefault();
    let i = Sl(e);
    i && je(e, i);
    return;
  }
  if (e.altKey) {
    let i = /^Digit(\d)$/.exec(e.code)?.[1];
    if (e.key === "ArrowLeft") return je(e, "back");
    if (e.key === "ArrowRight") return je(e, "forth");
    if (i === "0") return je(e, "store-view");
    if (i) {
      e.preventDefault();
      let a = Mt.all()[Number(i) - 1];
      a && Z(a[1], a[1].name ?? "view");
      return;
    }
    if (e.code === "KeyH" && je(e, "unhide"), !(e.code in Cr)) return;
  }
  let n = Sa();
  if (n && Ta(e)) return e.preventDefault();
  if (n && e.code in Cr)
    return vo = e.shiftKey ? 4 : e.altKey ? 0.25 : 1, xn(e.code), e.preventDefault();
  if (n && (e.key === "+" || e.key === "=")) return Pa(0.85);
  if (n && (e.key === "-" || e.key === "_")) return Pa(1 / 0.85);
  if (!or.peek()) return;
  if (e.shiftKey && Ea[e.code]) return je(e, Ea[e.code]);
  if (ho && /^\d$/.test(e.key)) {
    e.preventDefault(), ho = !1;
    let i = Ct.ids.peek()[Number(e.key) - 1];
    i !== void 0 && so({ do: "look", id: i, what: "recall", seconds: ir.peek() });
    return;
  }
  if (ho = e.key.toLowerCase() === "j", ho) return J("Recall a look: now its digit.");
  if (!e.shiftKey && /^\d$/.test(e.key) && oe.peek().length) {
    e.preventDefault(), vr.value = e.key;
    return;
  }
  if (!e.shiftKey && e.key !== "?" && Ca[e.code]) return je(e, Ca[e.code]);
  if (e.key === "\\") return void (e.repeat || yn(!0));
  let o = e.key.toLowerCase();
  if (o === "l" && !e.shiftKey) return void (e.repeat || ie("highlight"));
  if (o === "p" && e.shiftKey) return El();
  let r = e.shiftKey && Ma[o] ? Ma[o] : xl[o];
  r && !(e.target instanceof HTMLButtonElement && o === "enter") && je(e, r);
}
function El() {
  let [e, t] = _e.peek(), n = Nt(e / 2, t / 2);
  n && Me("point", n, (o) => o.hit && po(e / 2, t / 2, o));
}
function je(e, t) {
  e.preventDefault(), ie(t);
}
function Tl(e) {
  Wt.delete(e.code), e.key === "\\" && yn(!1), e.key.toLowerCase() === "l" && fo(!1), e.key === "Shift" && (vo = 1);
}
function Va() {
  addEventListener("keydown", Cl), addEventListener("keyup", Tl), addEventListener("blur", () => {
    Wt.clear(), fo(!1), yn(!1);
  }), navigator.keyboard?.getLayoutMap().then((t) => {
    $a.value = ["KeyW", "KeyA", "KeyS", "KeyD"].map((n) => (t.get(n) ?? n.slice(3)).toUpperCase()).join(" ");
  }).catch(() => {
  });
}
function Pl(e, t) {
  for (let n of ["KeyW", "KeyS", "KeyA", "KeyD"]) Wt.delete(n);
  vo = Math.min(1, Math.hypot(e, t)), e > 0.2 && xn("KeyW"), e < -0.2 && xn("KeyS"), t < -0.2 && xn("KeyA"), t > 0.2 && xn("KeyD");
}

// src/levels.ts
var Pr = (e) => Math.min(1, Zn.value === "square" ? Math.sqrt(Math.max(e, 0)) : e), $r = (e) => {
  let t = Zn.peek() === "square" ? e * e : e;
  return Math.round(t * 1e3) / 1e3;
}, $l = (e) => (e.kind === "lamp" ? k.get(e.id) : N.get(e.id))?.level ?? 0, go = (e) => (e.kind === "lamp" ? k.get(e.id) : N.get(e.id))?.name ?? "";
function Lr(e) {
  let t = oe.peek();
  return e.kind === "lamp" && T.peek()?.kind === "lamp" && t.length > 1 && t.includes(e.id) ? t : [e.id];
}
function Ia(e, t, n) {
  if (e.kind === "group") return { groups: { [e.id]: { level: t } } };
  let o = n.get(e.id) ?? 0, r = {};
  for (let [i, a] of n) {
    let s = i === e.id ? t : o > 0 ? Math.min(10, a * (t / o)) : t;
    r[i] = { level: Math.round(s * 1e3) / 1e3 };
  }
  return { lamps: r };
}
var Sn = class {
  constructor(t) {
    this.strip = t;
    this.was = this.now = $l(t), this.from = t.kind === "lamp" ? new Map(Lr(t).map((n) => [n, k.get(n)?.level ?? 0])) : /* @__PURE__ */ new Map(), this.gesture = new Ne(`${go(t)} level`);
  }
  strip;
  gesture;
  from;
  was;
  now;
  to(t) {
    this.now = t, this.gesture.set(Ia(this.strip, t, this.from));
  }
  end() {
    let t = this.from.size > 1 ? Qe([...this.from.keys()]) : go(this.strip);
    this.gesture.end(`${t} ${Re(this.was)} → ${Re(this.now)} %`);
  }
  cancel() {
    this.gesture.cancel();
  }
};
function bo(e, t) {
  let n = new Map(Lr(e).map((o) => [o, k.get(o)?.level ?? 0]));
  zo(`level ${e.kind} ${e.id}`, `${go(e)} level`, Ia(e, t, n));
}
function Vr(e, t) {
  if (!e.length) return;
  let n = Object.fromEntries(e.map((r) => {
    let i = k.get(r);
    return [r, { level: t(i?.level ?? 0, i?.flux ?? 1) }];
  })), o = e.length === 1 ? ` ${Re(k.get(e[0])?.level ?? 0)} → ${Re(n[e[0]].level)} %` : " level";
  ue(`${Qe(e)}${o}`, { lamps: n });
}
function Ir(e, t) {
  let n = t(N.get(e)?.level ?? 0);
  ue(`${N.get(e)?.name ?? "Group"} ${Re(n)} %`, { groups: { [e]: { level: n } } });
}
function Ar(e, t) {
  let n = `${go(e)} ${t ? "on" : "off"}`;
  e.kind === "group" ? ue(n, { groups: { [e.id]: { on: t } } }) : ue(n, { lamps: Object.fromEntries(Lr(e).map((o) => [o, { on: t }])) });
}

// src/swatch.ts
var Ll = (e) => e <= 31308e-7 ? 12.92 * e : 1.055 * e ** 0.4166666666666667 - 0.055, Vl = (e) => e <= 0.04045 ? e / 12.92 : ((e + 0.055) / 1.055) ** 2.4, Il = (e) => Math.round(255 * Ll(Math.max(0, Math.min(1, e))));
function Rr(e) {
  let t = Math.max(...e, 1e-6);
  return Aa(e.map((n) => n / t));
}
function Aa(e) {
  return `#${e.map((t) => Il(t).toString(16).padStart(2, "0")).join("")}`;
}
function Al(e) {
  let t = (n) => Vl(parseInt(e.slice(1 + 2 * n, 3 + 2 * n), 16) / 255);
  return [t(0), t(1), t(2)];
}
var Rl = (e) => 1e6 / e;

// src/range.tsx
var Ra = -1e9;
addEventListener("scroll", () => Ra = performance.now(), { capture: !0, passive: !0 });
var Bt = (e) => Math.max(0, Math.min(1, e));
function Kr(e) {
  let t = ne(null), n = ne(null), o = e.notch ?? 0.01, r = (c) => {
    if (c.button !== 0 || e.disabled) return;
    let u = c.currentTarget.getBoundingClientRect(), d = e.vertical ? (u.bottom - c.clientY - 8) / (u.height - 16) : (c.clientX - u.left - 6) / (u.width - 12), m = c.pointerType !== "touch" && !c.shiftKey;
    n.current = { id: c.pointerId, x: c.clientX, y: c.clientY, at: m ? Bt(d) : e.value }, t.current?.setPointerCapture(c.pointerId), t.current?.focus(), e.begin?.(), m && e.on(Bt(d));
  }, i = (c) => {
    let u = n.current;
    if (!u || u.id !== c.pointerId) return;
    let d = c.currentTarget.getBoundingClientRect(), m = e.vertical ? (u.y - c.clientY) / (d.height - 16) : (c.clientX - u.x) / (d.width - 12);
    u.x = c.clientX, u.y = c.clientY, u.at += m * (c.shiftKey ? 0.1 : 1), e.on(Bt(u.at));
  }, a = (c) => {
    n.current?.id === c.pointerId && (n.current = null, c.type === "pointercancel" ? e.cancel?.() : e.end?.());
  }, s = (c) => {
    if (c.key === "Escape" && n.current) {
      n.current = null, e.cancel?.(), c.stopPropagation();
      return;
    }
    let u = { ArrowUp: 1, ArrowRight: 1, ArrowDown: -1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[c.key], d = null;
    u && (d = Bt(e.value + u * o * (c.shiftKey ? 10 : 1))), c.key === "Home" && (d = 0), c.key === "End" && (d = 1), !(d === null || c.altKey || c.ctrlKey || c.metaKey) && (c.preventDefault(), c.stopPropagation(), e.on(d));
  }, p = (c) => {
    if (performance.now() - Ra < 400 || c.ctrlKey) return;
    c.preventDefault();
    let u = Math.abs(c.deltaY) >= Math.abs(c.deltaX) ? c.deltaY : c.deltaX;
    u && e.on(Bt(e.value - Math.sign(u) * o * (c.shiftKey ? 0.2 : 1)));
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
      style: { "--t": Bt(e.value), "--gradient": e.gradient ?? "" },
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
  return t.mode === "kelvin" ? `${z(t.kelvin)} K` : t.mode === "rgb" ? "RGB" : t.mode === "xy" ? "x y" : "file";
}
var Or = (e) => e.free ? "re-mix: level and colour cost no ray" : "re-trace: its light is traced anew";
function Oa({ row: e, index: t, count: n }) {
  let o = ne(null), r = { kind: e.kind, id: e.id }, i = e.kind === "lamp" ? k.get(e.id) : void 0, a = e.kind === "group" ? N.get(e.id) : void 0, s = i ?? a;
  if (!s) return null;
  let p = a?.lamps ?? [e.id], c = i ? i.flux : p.reduce((y, b) => y + (k.get(b)?.flux ?? 0) * (k.get(b)?.level ?? 0), 0), u = i ? i.flux * He(i) : p.reduce((y, b) => y + (k.get(b)?.flux ?? 0) * He(k.get(b)), 0), d = T.value?.kind === e.kind && T.value.ids.includes(e.id), m = p.length > 0 && p.every((y) => xe.value.includes(y)), f = xe.value.length > 0 && !p.some((y) => xe.value.includes(y)), _ = me.value?.kind === e.kind && me.value.id === e.id, w = `${d ? "selected" : ""} ${s.on && !i?.parked ? "" : "off"} ${f ? "muted" : ""} ${_ ? "under" : ""}`, S = {
    begin: () => o.current = new Sn(r),
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
      class: `fader-row depth-${e.depth} ${e.kind} ${w}`,
      role: "listitem",
      "aria-setsize": n,
      "aria-posinset": t + 1,
      "data-row": `${e.kind}-${e.id}`,
      onPointerEnter: () => me.value = { kind: e.kind, id: e.id },
      onPointerLeave: () => me.value = null,
      children: [
        l("button", { class: "icon power", "aria-pressed": s.on, "aria-label": `${s.name} on`, title: s.on ? "On (O)" : "Off (O)", onClick: () => Ar(r, !s.on), children: l(X, { name: "power" }) }),
        l("div", { class: "top", children: [
          a && l("button", { class: "icon fold", "aria-expanded": !gt.value.has(e.id), "aria-label": `Members of ${s.name}`, onClick: () => Ha(e.id), children: l(X, { name: gt.value.has(e.id) ? "right" : "down" }) }),
          l("button", { class: "row-name", "aria-pressed": d, title: i ? `${i.name}: ${Or(i)}` : s.name, onClick: (y) => Hr(y, e.kind, e.id), children: [
            l("span", { children: s.name }),
            a && l("small", { children: p.length }),
            i?.parked && l("small", { children: "parked" }),
            i && !i.free && l("small", { class: "traced", title: Or(i), children: [
              "↻",
              l("span", { class: "spoken", children: "re-trace" })
            ] })
          ] }),
          i && l("span", { class: "tint", children: [
            l("i", { class: "swatch", style: { background: Rr(i.swatch) } }),
            Ka(i)
          ] }),
          l("button", { class: "icon solo", "aria-pressed": m, "aria-label": `Solo ${s.name}`, title: "Solo (I)", onClick: () => xr(p), children: l(X, { name: "solo" }) })
        ] }),
        l("div", { class: "bottom", children: [
          l(
            Kr,
            {
              label: `${s.name} level`,
              class: "level",
              value: Pr(s.level),
              text: `${Re(s.level)} %, ${Ze(u)} lumen`,
              notch: 0.01,
              on: (y) => {
                let b = $r(y);
                o.current ? o.current.to(b) : bo(r, b);
              },
              reset: () => bo(r, 1),
              ...S
            }
          ),
          l(
            wn,
            {
              label: `${s.name} level, typed`,
              quantity: "level",
              value: s.level,
              flux: c,
              step: 0.01,
              set: (y) => i ? Vr(d && oe.peek().length > 1 ? oe.peek() : [e.id], y) : Ir(e.id, y)
            }
          ),
          l("span", { class: "lumens", children: _n(u, "flux") })
        ] })
      ]
    }
  );
}

// src/virtual.tsx
var Da = 4;
function Dr({ count: e, height: t, row: n, label: o, show: r, role: i = "list" }) {
  let a = ne(null), s = it(0), p = it(600);
  Ee(() => {
    let d = a.current, m = new ResizeObserver(() => p.value = d.clientHeight);
    return m.observe(d), () => m.disconnect();
  }, []), Ee(() => {
    let d = a.current;
    if (!d || r === void 0 || r < 0) return;
    let m = r * t;
    (m < d.scrollTop || m + t > d.scrollTop + d.clientHeight) && (d.scrollTop = Math.max(0, m - d.clientHeight / 2));
  }, [r, t]);
  let c = Math.max(0, Math.floor(s.value / t) - Da), u = Math.min(e, Math.ceil((s.value + p.value) / t) + Da);
  return l("div", { class: "virtual", ref: a, tabIndex: e ? void 0 : -1, onScroll: (d) => s.value = d.currentTarget.scrollTop, children: l("div", { class: "all", role: i, "aria-label": o, style: { height: `${e * t}px` }, children: l("div", { class: "rows", role: "presentation", style: { transform: `translateY(${c * t}px)` }, children: Array.from({ length: Math.max(0, u - c) }, (d, m) => n(c + m)) }) }) });
}

// src/lamps.tsx
var yo = g(""), gt = g(/* @__PURE__ */ new Set()), _o = g("group"), Fa = U(() => {
  let e = yo.value.trim().toLowerCase(), t = (r) => {
    let i = k.get(r);
    return i ? !e || `${i.name} ${i.kind} ${N.get(i.group)?.name ?? ""}`.toLowerCase().includes(e) : !1;
  };
  if (_o.value !== "group" && Rt.value === "sheet") {
    let r = _o.value, i = k.all().filter(([a]) => t(a));
    return i.sort(([, a], [, s]) => r === "name" ? a.name.localeCompare(s.name, "en", { numeric: !0 }) : s[r] - a[r]), i.map(([a]) => ({ kind: "lamp", id: a, depth: 0 }));
  }
  let n = [], o = /* @__PURE__ */ new Set();
  for (let [r, i] of N.all()) {
    i.lamps.forEach((s) => o.add(s));
    let a = i.lamps.filter(t);
    if (a.length) {
      if (i.lamps.length === 1) {
        n.push({ kind: "lamp", id: a[0], depth: 0 });
        continue;
      }
      n.push({ kind: "group", id: r, depth: 0 }), (!gt.value.has(r) || e) && a.forEach((s) => n.push({ kind: "lamp", id: s, depth: 1 }));
    }
  }
  for (let r of k.ids.value) !o.has(r) && t(r) && n.push({ kind: "lamp", id: r, depth: 0 });
  return n;
}), Na = !1;
N.ids.subscribe((e) => {
  Na || !e.length || (Na = !0, k.ids.peek().length > 40 && (gt.value = new Set(e.filter((t) => (N.get(t)?.lamps.length ?? 0) > 1))));
});
function Ha(e) {
  let t = new Set(gt.peek());
  t.delete(e) || t.add(e), gt.value = t;
}
function Hr(e, t, n) {
  e.shiftKey ? ea(t, Fa.peek().filter((o) => o.kind === t).map((o) => o.id), n) : Ie(t, n, e.ctrlKey || e.metaKey ? "toggle" : "only");
}
function Kl(e) {
  let t = { ArrowDown: 1, ArrowUp: -1 }[e.key], n = e.target;
  if (!t || !n.matches(".row-name")) return;
  e.preventDefault();
  let o = [...e.currentTarget.querySelectorAll(".row-name")];
  o[o.indexOf(n) + t]?.focus();
}
var Ol = ["add-spot", "add-point", "add-disc", "add-sphere"];
function ja() {
  let e = Fa.value, t = T.value?.ids[T.value.ids.length - 1], n = e.findIndex((i) => i.kind === T.value?.kind && i.id === t), o = matchMedia("(pointer: coarse)").matches, r = Rt.value === "sheet";
  return l("section", { class: "panel lamps", "aria-label": "Lamps", onKeyDown: Kl, children: [
    l("header", { class: "panel-head", children: [
      l("h2", { children: [
        "Lamps ",
        l("small", { children: z(k.ids.value.length) })
      ] }),
      l("span", { class: "gap" }),
      l("div", { class: "segments", role: "group", "aria-label": "Listing", children: [
        l("button", { "aria-pressed": !r, onClick: () => Rt.value = "faders", children: "Faders" }),
        l("button", { "aria-pressed": r, onClick: () => Rt.value = "sheet", children: "Sheet" })
      ] })
    ] }),
    l("div", { class: "panel-tools", children: [
      l("span", { class: "field filter", children: l(
        "input",
        {
          type: "text",
          "aria-label": "Filter lamps",
          placeholder: "Filter",
          value: yo.value,
          onInput: (i) => yo.value = i.currentTarget.value,
          onKeyDown: (i) => {
            i.key === "Escape" && (yo.value = "", i.stopPropagation());
          }
        }
      ) }),
      r && l("select", { "aria-label": "Order", value: _o.value, onChange: (i) => _o.value = i.currentTarget.value, children: [
        l("option", { value: "group", children: "by group" }),
        l("option", { value: "name", children: "by name" }),
        l("option", { value: "flux", children: "by flux" }),
        l("option", { value: "level", children: "by level" })
      ] }),
      l(Ut, { id: "add-menu", label: "Add", title: "Add a lamp", children: [
        Ol.map((i) => l(kr, { id: i }, i)),
        l("button", { class: "item", "aria-disabled": "true", title: "Photometric files come with a later version", children: [
          l("span", { children: "IES or LDT file…" }),
          l("kbd", { children: "later" })
        ] })
      ] })
    ] }),
    oe.value.length > 1 && l("p", { class: "several", children: [
      oe.value.length,
      " selected; a fader moves them in proportion",
      l("button", { onClick: () => ie("none"), children: "None" })
    ] }),
    r && l(te, { part: "SheetHead" }),
    l(
      Dr,
      {
        label: "Lamps and groups",
        count: e.length,
        height: r ? o ? 44 : 28 : o ? 84 : 54,
        show: n,
        row: (i) => {
          let a = e[i], s = r ? _r("SheetRow") : Oa;
          return s && l(s, { row: a, index: i, count: e.length }, `${a.kind}${a.id}`);
        }
      }
    ),
    !e.length && k.ids.value.length > 0 && l("p", { class: "quiet empty", children: "No lamp is called so." })
  ] });
}

// src/states.ts
var Mn = g(null), tt = g([]), Cn = g(null), Fr = g(null), Nr = U(() => Pe.value?.stage ?? "loading"), Hl = U(() => {
  let e = Pe.value?.fps ?? 0;
  return Nr.value === "moving" && e > 6 && At.value < 0.4 * e && At.value < 5;
}), Gt = U(() => {
  switch (B.value) {
    case "entering":
      return "starting";
    case "open":
      break;
    default:
      return B.value;
  }
  return !ee.value || !G.value ? "loading" : lt.value.state === "failed" ? "unsaved" : Mn.value !== null ? "broken" : Cn.value !== null && !W.value.you ? "control-lost" : de.value === "watch" || !W.value.you ? "watching" : k.ids.value.length === 0 ? "no-lamps" : Pi.value ? "all-off" : Hl.value ? "slow" : Nr.value === "loading" ? "first" : Nr.value;
});
Se("event", (e) => {
  switch (e.what) {
    case "reloaded": {
      Mn.value = null, tt.value = e.lost ?? [];
      let t = e.kept ?? 0;
      J(`The scene was read again: ${t} edits kept${tt.value.length ? `, ${tt.value.length} no longer find what they changed` : ""}.`);
      break;
    }
    case "broken":
      Mn.value = e.why ?? "The scene file cannot be read.";
      break;
    case "taken":
      Cn.value = e.by ?? W.peek().name ?? "somebody else";
      break;
    case "loading":
      Fr.value = e;
      break;
  }
});
Se("refused", (e) => J(e.why ?? "That could not be done.", "warn"));
E(() => {
  W.value.you && (Cn.value = null);
});

// src/probe.ts
var wo = g(null);
function ko(e, t, n) {
  let o = Nt(e, t);
  if (!o) return n(null);
  Me("point", o, (r) => n(r.hit ? r : null));
}
function qa(e) {
  if (!e) return "";
  let t = [], n = k.get(e.lamp)?.name, o = be.get(e.thing)?.name, r = St.get(e.material)?.name;
  if (n && t.push(n), o && o !== n && t.push(o), r && r !== o && t.push(r), e.lux && t.push(`${vt(e.lux[0])} ±${vt(e.lux[1], !1)}`), e.luminance) {
    let i = e.luminance[0] * (Kt.value === "fc" ? 0.2919 : 1);
    t.push(`${Ze(i)} ${Kt.value === "fc" ? "fL" : "cd/m²"}`);
  }
  return t.join(" · ");
}

// src/status.tsx
var Ua = U(() => {
  G.value;
  let e = [];
  for (let t of le.sent.slice(-24)) {
    if (t.what !== "set" && t.what !== "camera") continue;
    let n = le.frames.find((o) => o.seq >= t.seq && o.painted);
    n && n.painted > t.at && e.push(n.painted - (t.input || t.at));
  }
  return e.sort((t, n) => t - n), e.length ? e[e.length >> 1] : null;
});
function Dl() {
  let e = Pe.value;
  if (!e) return "starting";
  let t = e.error == null ? "" : ` ±${z((e.error ?? 0) * 100, e.error < 0.0995 ? 1 : 0)} %`;
  switch (e.stage) {
    case "loading":
      return "first look";
    case "moving":
      return `moving${t}`;
    case "refining":
      return `${t.trim() || "refining"}${e.good_in ? `, good in ${z(e.good_in, e.good_in < 3 ? 1 : 0)} s` : ""}`;
    case "good":
      return `good${t}`;
    case "done":
      return `finished${t}`;
  }
}
function Wa() {
  let e = Pe.value, t = G.value?.head, n = an.value.filter((r) => r.batches < r.of && !r.held).length, o = e?.stage === "refining" && e.good_in ? Math.max(0.02, 1 / (1 + e.good_in)) : e?.stage === "good" || e?.stage === "done" ? 1 : 0.02;
  return l("footer", { class: "status", "aria-label": "Status", children: [
    l("span", { class: `quality ${e?.stage ?? ""}`, children: [
      l("i", { class: "thin", "aria-hidden": "true", children: l("b", { style: { width: `${o * 100}%` } }) }),
      Dl()
    ] }),
    l("span", { children: [
      z(t?.batches ?? e?.batches ?? 0),
      " batches"
    ] }),
    l("span", { children: B.value === "open" ? `${z(At.value)} fps` : "no line" }),
    Ua.value !== null && l("span", { title: "From the hand to the paint, median", children: [
      z(Ua.value),
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
    l("span", { class: "probe", "aria-live": "off", children: qa(wo.value) }),
    l("span", { class: "gap" }),
    l("span", { children: W.value.you ? "editing: you" : `editing: ${W.value.name ?? "somebody else"}` }),
    l("span", { class: "spoken", children: [
      Go.value ?? "",
      " ",
      Gt.value
    ] })
  ] });
}

// src/pointer.ts
var Nl = 4, Ba = 35e-4, Fl = 0.15;
function jl(e, t, n) {
  return e === "maya" && n.alt ? ["orbit", "pan", "dolly"][t] ?? "none" : e === "blender" && t === 1 ? n.shift ? "pan" : n.ctrl ? "dolly" : "orbit" : t === 1 ? n.shift ? "pan" : "orbit" : t === 2 ? "look" : t === 0 ? n.alt ? "orbit" : n.space ? "pan" : n.shift || n.ctrl ? "none" : "look" : "none";
}
function Ga(e, t) {
  let n = /* @__PURE__ */ new Map(), o = Ft(), r = 3, i = !1, a = 0, s = 0, p = 0, c = null, u = (h) => {
    let v = e.getBoundingClientRect();
    return [h.clientX - v.left, h.clientY - v.top];
  }, d = (h, v, P) => {
    let $ = Nt(h, v);
    $ && Me("point", $, (L) => {
      let I = L;
      I.hit && P?.(I);
    });
  }, m = (h) => {
    let v = mt();
    return v ? Math.max(0.2, O(A(h, v.eye), v.forward)) : r;
  };
  function f(h) {
    if (h.target.closest("[data-handle]")) return;
    e.focus({ preventScroll: !0 });
    let [v, P] = u(h), $ = h.pointerType === "touch", L = { alt: h.altKey, shift: h.shiftKey, ctrl: h.ctrlKey || h.metaKey, space: i }, I = $ ? "look" : jl(Jn.peek(), h.button, L);
    I === "look" && re()?.height && (I = "pan"), H.peek() === "marquee" && h.button === 0 && (I = "none"), n.set(h.pointerId, {
      id: h.pointerId,
      button: h.button,
      x: v,
      y: P,
      startX: v,
      startY: P,
      moved: !1,
      motion: I,
      touch: $,
      shift: h.shiftKey,
      ctrl: L.ctrl
    }), e.setPointerCapture(h.pointerId), clearTimeout(a), t.unhover(), (I === "orbit" || I === "pan" || I === "dolly") && (o = Ft(), r = m(o), d(v, P, (K) => {
      o = K.point, r = m(K.point);
    })), clearTimeout(s), $ && n.size === 1 && (s = window.setTimeout(() => {
      let K = n.get(h.pointerId);
      K && !K.moved && n.size === 1 && (K.moved = !0, K.motion = "none", t.menu(K.x, K.y));
    }, 550)), n.size === 2 && (c = _()), h.button === 1 && h.preventDefault();
  }
  function _() {
    let [h, v] = [...n.values()];
    return { gap: Math.hypot(h.x - v.x, h.y - v.y), x: (h.x + v.x) / 2, y: (h.y + v.y) / 2 };
  }
  function w(h) {
    let v = n.get(h.pointerId), [P, $] = u(h);
    if (!v) {
      if (h.pointerType === "touch" || h.buttons) return;
      t.unhover(), clearTimeout(a), a = window.setTimeout(() => t.hover(P, $), 150);
      return;
    }
    let [L, I] = [P - v.x, $ - v.y];
    if (!(!v.moved && Math.hypot(P - v.startX, $ - v.startY) < Nl)) {
      if (v.moved = !0, v.x = P, v.y = $, n.size === 2 && c) {
        let K = _();
        jt(K.x - c.x, K.y - c.y, r), K.gap > 8 && c.gap > 8 && b(K.x, K.y, c.gap / K.gap, !1), c = K;
        return;
      }
      if (H.peek() === "marquee" && v.button === 0) {
        t.marquee([v.startX, v.startY], [P, $], !1);
        return;
      }
      switch (v.motion) {
        case "look": {
          let K = v.touch ? 1 : -1;
          no(K * L * Ba, K * I * Ba);
          break;
        }
        case "orbit":
          oo(o, -L * 6e-3, -I * 6e-3);
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
    if (n.delete(h.pointerId), clearTimeout(s), n.size < 2 && (c = null), !(!v || h.type === "pointercancel")) {
      if (v.moved) {
        H.peek() === "marquee" && t.marquee([v.startX, v.startY], [v.x, v.y], !0);
        return;
      }
      if (v.touch) {
        let P = performance.now(), $ = P - p < 320;
        if (p = P, $) return t.double();
        if (Ve.peek()) return;
      }
      if (v.button === 2) t.menu(v.x, v.y);
      else if (v.button === 0) {
        let P = v.shift ? "add" : v.ctrl ? "toggle" : "only";
        t.click(v.x, v.y, P);
      }
    }
  }
  let y = null;
  function b(h, v, P, $) {
    let L = re(), I = mt();
    if (!L || !I) return;
    if (L.height) return Z(Yn(L, I, h, v, P));
    let K = performance.now();
    if (!y || K - y.time > 500 || Math.hypot(h - y.x, v - y.y) > 6) {
      y = { x: h, y: v, time: K, point: null };
      let yt = y;
      d(h, v, (Br) => {
        yt.point = Br.point, r = m(Br.point);
      });
    }
    y.time = K;
    let [os, rs] = [h - I.width / 2, I.height / 2 - v], is = Math.min(r, Ce(L.eye, Ft()) + 1), xo = (yt) => L.eye[yt] + (I.forward[yt] + I.side[yt] * os * I.pixel + I.up[yt] * rs * I.pixel) * is, Wr = y.point ?? [xo(0), xo(1), xo(2)];
    Z(Xn(L, Wr, P, Fl, $)), $ && Ce(L.eye, Wr) < 0.5 && (y = null);
  }
  function R(h) {
    if (h.target.closest("[data-scroll]")) return;
    h.preventDefault();
    let v = h.deltaMode === 1 ? 18 : h.deltaMode === 2 ? 400 : 1, [P, $] = [h.deltaX * v, h.deltaY * v], [L, I] = u(h);
    if (Jn.peek() === "trackpad" && !h.ctrlKey) return jt(-P, -$, r);
    let K = (h.ctrlKey ? 6 : 1) * (Math.abs($) > Math.abs(P) ? $ : P);
    b(L, I, Math.exp(Math.max(-300, Math.min(300, K)) * 16e-4), h.shiftKey && !h.ctrlKey);
  }
  let V = (h) => h.preventDefault(), qe = () => {
    clearTimeout(a), t.unhover();
  }, Ue = (h) => {
    !h.target.closest("[data-handle]") && H.peek() === null && t.double();
  }, ke = (h) => {
    h.code === "Space" && (i = h.type === "keydown");
  }, ge = new ResizeObserver(() => {
    let h = e.getBoundingClientRect();
    _e.value = [Math.max(16, Math.round(h.width)), Math.max(16, Math.round(h.height))];
  });
  return ge.observe(e), e.addEventListener("pointerdown", f), e.addEventListener("pointermove", w), e.addEventListener("pointerup", S), e.addEventListener("pointercancel", S), e.addEventListener("pointerleave", qe), e.addEventListener("wheel", R, { passive: !1 }), e.addEventListener("contextmenu", V), e.addEventListener("dblclick", Ue), addEventListener("keydown", ke), addEventListener("keyup", ke), () => {
    ge.disconnect(), removeEventListener("keydown", ke), removeEventListener("keyup", ke);
  };
}

// src/overlay.ts
var ql = "http://www.w3.org/2000/svg";
function we(e, t = {}, n) {
  let o = document.createElementNS(ql, e);
  for (let [r, i] of Object.entries(t)) o.setAttribute(r, String(i));
  return n?.append(o), o;
}
var qr = class {
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
    let [, , o] = pn(this.view, t), [, , r] = pn(this.view, n), i = 0.05, [a, s] = [t, n];
    if (!this.view.parallel) {
      if (o < i && r < i) return "";
      let u = (i - o) / (r - o), d = M(x(t, 1 - u), x(n, u));
      o < i && (a = d), r < i && (s = d);
    }
    let [p, c] = [this.at(a), this.at(s)];
    return !p || !c ? "" : `M${p[0].toFixed(1)} ${p[1].toFixed(1)}L${c[0].toFixed(1)} ${c[1].toFixed(1)}`;
  }
};
function Ur() {
  let e = G.value;
  return _e.value, e ? new qr(Vt(e.camera, e.head.width, e.head.height)) : null;
}
function za() {
  let e = se(Ur);
  return e ? k.all().flatMap(([t, n]) => {
    let o = Xa(n), r = o && e.at(o);
    return r ? [{ id: t, at: r }] : [];
  }) : null;
}
var Xa = io, Ul = [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
function jr(e, t) {
  let n = Lt(t);
  return Ul.map(([o, r]) => e.line(n[o], n[r])).join("");
}
var En = class {
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
function Ya(e) {
  let t = we("path", { class: "aims" }, e), n = we("path", { class: "boxes" }, e), o = we("path", { class: "boxes hover" }, e), r = we("path", { class: "grid-lines" }, e), i = new En(we("g", {}, e), "lamp", (u) => we("circle", { r: 4.5 }, u)), a = new En(we("g", {}, e), "grid", () => {
  }), s = new En(we("g", {}, e), "meter", (u) => {
    we("circle", { r: 5.5 }, u), we("path", { d: "M-9 0H9M0 -9V9" }, u);
  }), p = E(() => {
    let u = Ur();
    if (!u) return;
    let d = T.value, m = me.value, f = "", _ = "", w = k.all().map(([y, b]) => {
      let R = d?.kind === "lamp" ? d.ids.includes(y) : d?.kind === "group" && d.ids.includes(b.group ?? -1), V = m?.kind === "lamp" ? m.id === y : m?.kind === "group" && m.id === b.group, qe = Xa(b), Ue = b.place?.position;
      if (R && b.box && (_ += jr(u, b.box)), Ue && b.place?.direction && (R || V)) {
        let h = b.place.aim ?? M(Ue, b.place.direction);
        f += u.line(Ue, h);
      }
      let ke = R || V || rr.value && (b.own || b.place?.position), ge = `${R ? "selected" : ""} ${V ? "under" : ""} ${He(b) ? "" : "off"}`;
      return { id: y, at: qe && ke ? u.at(qe) : null, label: R || V ? b.name : "", state: ge };
    });
    if (i.draw(w), t.setAttribute("d", f), d?.kind === "thing")
      for (let y of d.ids) {
        let b = be.get(y)?.box;
        b && (_ += jr(u, b));
      }
    n.setAttribute("d", _);
    let S = m?.kind === "lamp" ? k.get(m.id)?.box : m?.kind === "thing" ? be.get(m.id)?.box : null;
    o.setAttribute("d", S ? jr(u, S) : "");
  }), c = E(() => {
    let u = Ur();
    if (!u) return;
    let d = T.value, m = (_, w) => d?.kind === _ && d.ids.includes(w) ? "selected" : "";
    s.draw(Oe.all().map(([_, w]) => ({
      id: _,
      at: u.at(w.point),
      label: w.lux ? vt(w.lux[0]) : "…",
      state: m("meter", _)
    })));
    let f = "";
    a.draw(at.all().map(([_, w]) => {
      f += Wl(u, w);
      let S = w.mean == null ? "…" : `${w.name} ${vt(w.mean)}`;
      return { id: _, at: u.at(w.corner), label: S, state: m("grid", _) };
    })), r.setAttribute("d", f);
  });
  return () => {
    p(), c(), e.replaceChildren();
  };
}
function Wl(e, t) {
  let n = (r, i) => M(t.corner, M(x(t.u, r), x(t.v, i))), o = e.line(n(0, 0), n(1, 0)) + e.line(n(1, 0), n(1, 1)) + e.line(n(1, 1), n(0, 1)) + e.line(n(0, 1), n(0, 0));
  for (let r = 0; r < t.rows; r++)
    for (let i = 0; i < t.columns; i++) {
      let a = e.at(n((i + 0.5) / t.columns, (r + 0.5) / t.rows));
      a && (o += `M${(a[0] - 2).toFixed(1)} ${a[1].toFixed(1)}h4m-2 -2v4`);
    }
  return o;
}

// src/banner.tsx
function pe({ tone: e, children: t }) {
  return l("div", { class: `banner ${e}`, role: e === "warn" ? "alert" : "status", children: t });
}
var Qa = () => `lampyris view ${ee.peek()?.file ?? "SCENE"} --port ${location.port || 80}`;
function Bl() {
  let e = k.all().filter(([, n]) => !n.on || n.level === 0 || n.parked), t = N.all().filter(([, n]) => !n.on || n.level === 0);
  ue("All lamps on", {
    lamps: Object.fromEntries(e.map(([n, o]) => [n, { on: !0, parked: !1, ...o.level === 0 ? { level: 1 } : {} }])),
    groups: Object.fromEntries(t.map(([n, o]) => [n, { on: !0, ...o.level === 0 ? { level: 1 } : {} }]))
  });
}
function Gl() {
  switch (Gt.value) {
    case "starting":
      return l(pe, { tone: "calm", children: "Entering…" });
    case "loading": {
      let e = Fr.value;
      return l(pe, { tone: "calm", children: [
        "Reading ",
        e?.file ?? ee.value?.file ?? "the scene",
        "…",
        e?.bytes ? ` ${z(e.bytes / 1e6, 1)} MB` : "",
        e?.progress != null && l("progress", { value: e.progress, max: 1, "aria-label": "Reading" })
      ] });
    }
    case "lost":
      return l(pe, { tone: "warn", children: [
        "Connection lost, trying again",
        un.value ? ` (${un.value} s)` : "…",
        ". Until then nothing can be changed."
      ] });
    case "ended":
      return l(pe, { tone: "warn", children: [
        l("span", { children: [
          "The program has ended. Start it again with ",
          l("code", { children: Qa() }),
          ": this page comes back by itself."
        ] }),
        l("button", { onClick: () => {
          br(Qa());
        }, children: "Copy" })
      ] });
    case "denied":
      return l(pe, { tone: "warn", children: "This link is not valid (any more). Open the one that the program has printed, or ask for a new one." });
    case "renewed":
      return l(pe, { tone: "warn", children: [
        "New version. ",
        l("button", { onClick: () => location.reload(), children: "Reload" })
      ] });
    case "unsaved":
      return l(pe, { tone: "warn", children: [
        "Edits are not being saved: ",
        lt.value.why ?? "unknown reason",
        ".",
        l("button", { onClick: () => ht.value = "save", children: "Save elsewhere" })
      ] });
    case "broken":
      return l(pe, { tone: "warn", children: [
        Mn.value,
        " Still showing what was read before."
      ] });
    case "control-lost":
      return l(pe, { tone: "warn", children: [
        l("span", { children: [
          "Control moved to ",
          l("em", { children: Cn.value }),
          "."
        ] }),
        " ",
        l("button", { onClick: () => F({ do: "edit", what: "take" }), children: "Take it back" })
      ] });
    case "watching":
      return l(pe, { tone: "calm", children: [
        l("span", { children: [
          "You are watching",
          W.value.name ? l(Y, { children: [
            "; ",
            l("em", { children: W.value.name }),
            " edits"
          ] }) : "",
          "."
        ] }),
        l("button", { onClick: () => F({ do: "edit", what: "take" }), children: "Ask for control" })
      ] });
    case "no-lamps":
      return l(pe, { tone: "calm", children: [
        "This scene has no light. Add:",
        l(
          "button",
          {
            onClick: () => {
              ro.value = "disc", dr("add");
            },
            children: "ceiling lamp"
          }
        ),
        l("button", { disabled: !0, title: "Photometric files come with a later version", children: "IES file" })
      ] });
    case "all-off":
      return l(pe, { tone: "warn", children: [
        "All lamps are off.",
        st.value.undo && l("button", { onClick: () => ie("undo"), children: "Undo" }),
        l("button", { onClick: Bl, children: "Turn on" })
      ] });
    case "slow":
      return l(pe, { tone: "calm", children: [
        "Slow connection.",
        l("button", { "aria-pressed": Ye.value, onClick: () => Ye.value = !0, children: "Sharper" }),
        l("button", { "aria-pressed": !Ye.value, onClick: () => Ye.value = !1, children: "Faster" })
      ] });
    default:
      return null;
  }
}
function Ja() {
  let e = xe.value;
  return l("div", { class: "banners", "data-scroll": !0, children: [
    Gl(),
    tt.value.length > 0 && l(pe, { tone: "calm", children: [
      l("details", { children: [
        l("summary", { children: [
          tt.value.length,
          " edits no longer find what they changed"
        ] }),
        l("ul", { children: tt.value.map((t) => l("li", { children: t }, t)) })
      ] }),
      l("button", { onClick: () => tt.value = [], children: "Good" })
    ] }),
    e.length > 0 && l("div", { class: "banner badge", role: "status", children: [
      "Solo: ",
      e.length === 1 ? k.get(e[0])?.name ?? "one lamp" : `${e.length} lamps`,
      l("button", { onClick: Sr, children: "End solo" })
    ] }),
    l("div", { class: "notes", role: "status", "aria-live": "polite", children: ct.value.map((t) => l("div", { class: `banner ${t.tone === "warn" ? "warn" : "calm"}`, children: [
      t.text,
      l("button", { class: "icon", "aria-label": "Close", onClick: () => Uo(t.id), children: l(X, { name: "close" }) })
    ] }, t.id)) })
  ] });
}

// src/view.tsx
var es = g(null);
function zl(e, t) {
  let n = za();
  if (!n) return [];
  let [o, r] = [Math.min(e[0], t[0]), Math.max(e[0], t[0])], [i, a] = [Math.min(e[1], t[1]), Math.max(e[1], t[1])];
  return n.filter(({ at: s }) => s[0] >= o && s[0] <= r && s[1] >= i && s[1] <= a).map(({ id: s }) => s);
}
var Xl = {
  click(e, t, n) {
    let o = Za(e, t);
    if (H.peek() === null && o) return Ie(o.kind, o.id, n);
    ko(e, t, (r) => {
      if (r && (to.value = { point: r.point, normal: r.normal }), H.peek() !== null) return la(r);
      na(r, n), T.peek() && (Ae.value = "inspector");
    });
  },
  menu(e, t) {
    ko(e, t, (n) => {
      n && po(e, t, n);
    });
  },
  double() {
    fr();
  },
  hover(e, t) {
    let n = Za(e, t);
    n?.kind === "lamp" && (me.value = { kind: "lamp", id: n.id }), ko(e, t, (o) => {
      wo.value = o, o && (to.value = { point: o.point, normal: o.normal }), o?.lamp != null && (me.value = { kind: "lamp", id: o.lamp });
    });
  },
  unhover() {
    me.peek() && (me.value = null);
  },
  marquee(e, t, n) {
    if (es.value = n ? null : { from: e, to: t }, !n) return;
    let o = zl(e, t);
    T.value = o.length ? { kind: "lamp", ids: o } : null, H.value = null;
  }
};
function Za(e, t) {
  let n = document.getElementById("overlay"), o = null, r = 11;
  for (let i of n?.querySelectorAll(".mark:not([display])") ?? []) {
    let a = /translate\(([-\d.]+) ([-\d.]+)\)/.exec(i.getAttribute("transform") ?? "");
    if (!a) continue;
    let s = Math.hypot(Number(a[1]) - e, Number(a[2]) - t);
    s < r && (r = s, o = { kind: i.dataset.kind, id: Number(i.dataset.id) });
  }
  return o;
}
var Yl = {
  aim: "Click what shall be lit. Esc to leave.",
  meter: "Click where the meter shall lie. Esc to leave.",
  grid: "Click two opposite corners of the area. Esc to leave.",
  add: "Click where the lamp shall hang. Esc to leave.",
  marquee: "Drag around the lamps to select. Esc to leave."
};
function ts() {
  let e = ne(null), t = ne(null), n = ne(null);
  return Ee(() => {
    Jo(t.current);
    let o = Ya(n.current), r = Ga(e.current, Xl);
    return () => {
      Jo(null), o(), r();
    };
  }, []), Mi(() => {
    let o = G.value;
    t.current?.setAttribute("data-kind", o?.head.kind ?? "none");
  }), l("main", { class: "view", "aria-label": "View", children: [
    l(
      "div",
      {
        class: H.value ? "stage tooled" : "stage",
        id: "view",
        ref: e,
        tabIndex: 0,
        role: "application",
        "aria-label": `View of ${ee.value?.name ?? "the scene"}${Dt.value ? `, ${Dt.value}` : ""}`,
        "aria-describedby": "view-keys",
        "data-tool": H.value ?? "",
        children: [
          l("canvas", { ref: t, width: 640, height: 480, "aria-hidden": "true" }),
          l("svg", { id: "overlay", ref: n, "aria-hidden": "true" }),
          l(te, { part: "Gizmo" }),
          l(te, { part: "Compare" }),
          l(Ql, {})
        ]
      }
    ),
    l("p", { id: "view-keys", class: "spoken", children: "Arrow keys look around, W A S D and Q E walk, plus and minus go nearer and farther, F frames the selection, Escape leaves the view." }),
    H.value && l("p", { class: "hint", role: "status", children: Yl[H.value] }),
    l(Ja, {}),
    l(te, { part: "Legend" }),
    l(te, { part: "CutBar" }),
    l(te, { part: "ViewStrip" }),
    l(te, { part: "WalkPad" }),
    l(te, { part: "What" })
  ] });
}
function Ql() {
  let e = es.value;
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
function Jl() {
  return l(Y, { children: [
    l(wa, {}),
    l(ja, {}),
    l(ts, {}),
    l("section", { class: "panel inspector", "aria-label": "Inspector", children: l(te, { part: "Inspector" }) }),
    l("section", { class: "strip", "aria-label": "Looks and meters", children: l(te, { part: "Strip" }) }),
    l(Wa, {}),
    l(te, { part: "Sheets" })
  ] });
}
var bt = document.getElementById("desk");
bt.replaceChildren();
ii(l(Jl, {}), bt);
E(() => {
  bt.dataset.state = Gt.value, bt.dataset.line = B.value, bt.dataset.pen = de.value === "edit" && W.value.you && !Ve.value ? "yes" : "no";
});
E(() => {
  bt.dataset.panels = nr.value ? "yes" : "no", bt.dataset.drawer = Ae.value ?? "none";
});
E(() => {
  document.documentElement.dataset.theme = Zo.value, document.documentElement.style.setProperty("--house", String(er.value));
});
E(() => {
  ee.value && (document.title = `${ee.value.name} – Lampyris`);
});
var ns = 0;
E(() => {
  let [e, t] = _e.value, n = Ye.value ? Math.min(devicePixelRatio, 2) : 1;
  B.value !== "open" || de.value === "watch" || !W.value.you || (clearTimeout(ns), ns = window.setTimeout(() => F({ do: "size", width: Math.round(e * n), height: Math.round(t * n) }), 60));
});
va();
Va();
Oi();
export {
  Sn as Fade,
  wn as Field,
  Y as Fragment,
  Ne as Gesture,
  X as Icon,
  kr as Item,
  Ks as PRESETS,
  Kr as Range,
  Dr as Virtual,
  pt as across,
  ie as act,
  M as add,
  ca as addMeter,
  ro as adding,
  ua as aim,
  dl as allActions,
  Me as ask,
  Gs as back,
  bn as before,
  Kt as candles,
  oe as chosenLamps,
  Sr as clearSolo,
  mo as closeWhat,
  Ka as colorText,
  so as command,
  yn as compareHeld,
  ve as comparing,
  zi as compass,
  U as computed,
  ol as copyAlong,
  br as copyText,
  Or as cost,
  ce as cross,
  Rr as css,
  Zs as cut,
  eo as deselect,
  z as digits,
  ut as display,
  Ce as distance,
  O as dot,
  sl as each,
  ue as edit,
  W as editor,
  E as effect,
  lo as exposeBy,
  ir as fade,
  ul as falseColor,
  Ts as filterOf,
  Ye as fine,
  hn as fitted,
  _n as format,
  zs as forth,
  fr as frameSelection,
  Al as fromHex,
  Z as go,
  pr as goHome,
  Js as goInside,
  Qs as goPreset,
  at as grids,
  N as groups,
  Us as handles,
  Jn as hands,
  Se as hear,
  re as here,
  Aa as hex,
  fo as highlight,
  st as history,
  er as houseLights,
  me as hovered,
  l as jsx,
  l as jsxs,
  rr as lampMarks,
  k as lamps,
  an as layers,
  Fe as length,
  Rt as listing,
  Ve as lookOnly,
  Ct as looks,
  vt as luxText,
  js as maintenance,
  St as materials,
  Oe as meters,
  ze as middle,
  Rl as mired,
  ta as nameOf,
  j as normal,
  He as output,
  Pl as padWalk,
  nr as panels,
  Re as percent,
  Hr as pickRow,
  Vt as pinhole,
  il as placed,
  io as positionOf,
  al as positions,
  pn as project,
  Rs as ray,
  pl as register,
  rl as removeLamps,
  de as role,
  J as say,
  x as scale,
  ee as scene,
  Ie as select,
  T as selection,
  F as send,
  el as setCut,
  ht as sheet,
  $t as show,
  G as shown,
  g as signal,
  or as singleKeys,
  _l as soloSelection,
  fa as spacing,
  to as spot,
  dr as startTool,
  Pe as status,
  Ws as stepSelection,
  fl as storeLook,
  cl as storeView,
  zo as stroke,
  bo as strokeLevel,
  A as sub,
  Ar as switchOn,
  Zo as theme,
  be as things,
  Ze as three,
  Qe as titleOf,
  $r as toLevel,
  Pr as toTravel,
  gr as toggleFalse,
  vl as toggleWipe,
  H as tool,
  Zn as travel,
  fn as turn,
  Ir as typeGroupLevel,
  Vr as typeLevel,
  he as up,
  Ee as useEffect,
  hs as useLayoutEffect,
  ne as useRef,
  Dt as viewName,
  _e as viewSize,
  Mt as views,
  $a as walkNames,
  tr as walking,
  vr as wantLevel,
  et as what,
  Bn as whyNot,
  yr as whyNotTo,
  ml as wipeAt
};
