//! Questions that are put to a desk.

use super::Desk;
use crate::printer::Order;
use crate::studio::{Asked, What};
use crate::wire::Question;
use lampyris::eye::Meter;
use lampyris::geometry::Ray;
use serde_json::json;

impl Desk {
    /// A question of anybody's. Most are answered later, by whoever knows.
    pub(super) fn answer(&mut self, client: u64, id: u32, question: Question) -> Result<bool, String> {
        let what = match question {
            Question::Point { frame, x, y } => {
                let frame = self.screen.frame(frame).ok_or("this frame is too old to ask about")?;
                let inside = |at: f32, size: u32| (0.0..=size as f32).contains(&at);
                if !inside(x, frame.size[0]) || !inside(y, frame.size[1]) {
                    return Err("this lies outside of the frame".into());
                }
                let compared = self.against().map(|(then, _)| [self.colors(), then]);
                What::Pixel(frame, [x, y], compared)
            }
            Question::Ray { origin, direction } => {
                let direction = direction.try_normalize().filter(|_| origin.is_finite());
                What::Ray(Ray::new(origin, direction.ok_or("this ray leads nowhere")?))
            }
            Question::Light { point, normal } => {
                let normal = normal.try_normalize().filter(|_| point.is_finite());
                What::Light(Meter { position: point, normal: normal.ok_or("this point faces nowhere")? })
            }
            Question::Command => {
                let text = self.command();
                self.hub.tell(client, &json!({"is": "answer", "id": id, "text": text}));
                return Ok(false);
            }
            Question::Picture { format, width, height, batches } => {
                let order = Order { client, id, format, size: [width, height], batches };
                order.check()?;
                self.orders.push(order);
                self.save(None);
                self.print();
                return Ok(false);
            }
        };
        self.studio.ask(Asked { client, id, what });
        Ok(false)
    }
}
