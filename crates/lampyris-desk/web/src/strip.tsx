export function Strip() { return <section class="panel strip" />; }
