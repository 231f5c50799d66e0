export function Lamps() { return <section class="panel lamps" />; }
