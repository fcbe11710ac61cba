//! Shows scenes that `zstrip bake MODEL -o scene.zsc` has written on the display of a microcontroller, with the pixels
//! that `zstrip render` draws. No heap and no float: all data lie in one buffer that the program lends.
//!
//! ```no_run
//! # fn send(_: zstrip::Strip) {}
//! # fn milliseconds() -> u32 { 0 }
//! static SCENE: &[u8] = zstrip::include_scene!("scene.zsc");
//! # fn main() -> Result<(), zstrip::Error> {
//! let mut memory = [0; 24 * 1024];
//! let mut player = zstrip::Player::new(&mut memory)?;
//! player.open(SCENE)?;
//! player.fit(240, 240, zstrip::Format::Rgb565Swapped, &zstrip::FitOptions::default())?;
//! loop {
//!     player.play(milliseconds());
//!     player.draw(|strip| send(strip))?;
//! }
//! # }
//! ```
#![no_std]
#![deny(missing_docs)]
// An error holds its message: the player's own would be overwritten by the next call.
#![allow(clippy::result_large_err)]

mod raw;

use core::fmt;
use core::marker::PhantomData;
use core::{ptr, slice, str};

/// The bytes of a `.zsc` file at an address that [`Player::open`] accepts.
#[macro_export]
macro_rules! include_scene {
    ($path:expr) => {{
        static SCENE: &$crate::Aligned<[u8]> = &$crate::Aligned(*include_bytes!($path));
        &SCENE.0
    }};
}

/// Bytes whose address is a multiple of 4.
#[repr(C, align(4))]
pub struct Aligned<T: ?Sized>(pub T);

/// Layouts of pixels in memory: docs/conventions.md, "Picture formats".
#[repr(C)]
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
#[allow(missing_docs)]
pub enum Format {
    Rgb565,
    Rgb565Swapped,
    Gray4,
    Mono,
    Rgb666,
    Rgb444,
    Xrgb8888,
}

/// Kinds of things that a pixel shows.
#[repr(C)]
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
#[allow(missing_docs)]
pub enum Shown {
    Background,
    Instance,
    Outline,
    Quadric,
    Line,
    Sprite,
    Label,
}

/// The thing that a pixel shows.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct Picked {
    /// The kind says which of the scene's tables `index` refers to.
    pub shown: Shown,
    /// The number of the instance, quadric, set of lines, sprite or label; of an outline that of its instance.
    pub index: u16,
    /// The triangle of the instance's mesh, or of the outline's hull; of a line its index in the set; else 0.
    pub triangle: u32,
    /// The place in the triangle's own texture, in 1/65536 of its width and height.
    pub texture: Option<(u16, u16)>,
}

/// A rectangle of the picture, in pixels.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Eq, PartialEq)]
#[allow(missing_docs)]
pub struct Area {
    pub left: u16,
    pub top: u16,
    pub width: u16,
    pub height: u16,
}

/// The pixels of a rectangle. Its rows follow each other; each begins at a byte.
#[derive(Clone, Copy, Debug)]
pub struct Strip<'p> {
    /// The place in the picture.
    pub area: Area,
    /// Pixels in the format that was fitted.
    pub pixels: &'p [u8],
    /// A byte a pixel, with [`FitOptions::masked`]: 255 if something was drawn, 0 if not.
    pub mask: Option<&'p [u8]>,
}

/// Options of a plan.
#[derive(Clone, Copy, Debug, Default)]
pub struct FitOptions {
    /// Rows of a strip, if a plan with so many fits; 0: the planner decides.
    pub strip_rows: u16,
    /// Strips have a multiple of so many rows: 0 or 1, or 8 for displays with bytes of eight rows.
    pub row_step: u16,
    /// Strips have a mask, for a byte more for each pixel of a strip.
    pub masked: bool,
    /// [`Player::changed`] knows single instances, for 12 bytes each.
    pub tracks_changes: bool,
}

/// A clip: a named animation of the scene.
#[derive(Clone, Copy, Debug)]
pub struct Clip<'p> {
    /// The name in the model's file; empty if it is not UTF-8.
    pub name: &'p str,
    /// The duration.
    pub milliseconds: u32,
}

/// Counts the ones of a word. Compilers for processors without such an instruction call it by this name, from libgcc;
/// `compiler_builtins` does not have it.
#[cfg(target_os = "none")]
#[no_mangle]
extern "C" fn __popcountsi2(word: u32) -> raw::Int {
    word.count_ones() as raw::Int
}

const MAX_WORDS: usize = 160;

/// The message about a fault: what is wrong and what to do.
#[derive(Clone, Copy, Eq, PartialEq)]
pub struct Error {
    words: [u8; MAX_WORDS],
    bytes: usize,
}

impl Error {
    fn new(message: &[u8]) -> Error {
        let bytes = message.len().min(MAX_WORDS);
        let mut words = [0; MAX_WORDS];
        words[..bytes].copy_from_slice(&message[..bytes]);
        Error { words, bytes }
    }

    /// Returns the message.
    pub fn message(&self) -> &str {
        str::from_utf8(&self.words[..self.bytes]).unwrap_or("a fault")
    }
}

impl fmt::Display for Error {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str(self.message())
    }
}

impl fmt::Debug for Error {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "Error({:?})", self.message())
    }
}

/// Restores the baked background: an argument of `zstrip_player_background`.
const BAKED_BACKGROUND: u32 = 0xFFFF_FFFF;
const MAX_TEXT: usize = 24;

/// A baked scene on a display. The player and all its data lie in the memory that it borrows.
pub struct Player<'a> {
    raw: *mut raw::Opaque,
    height: u16, // of the picture that was fitted last
    borrowed: PhantomData<(&'a mut [u8], &'a [u8])>,
}

// The player has no data outside of its memory, which it borrows exclusively.
unsafe impl Send for Player<'_> {}

impl<'a> Player<'a> {
    /// Makes a player in `memory`, at any address. It is an error if the memory is too small for the player itself.
    pub fn new(memory: &'a mut [u8]) -> Result<Player<'a>, Error> {
        // The memory is borrowed as long as the player, and the pipeline is a constant.
        let raw = unsafe {
            raw::zstrip_player_in(memory.as_mut_ptr(), memory.len(), ptr::addr_of!(raw::zstrip_rust_pipeline))
        };
        if raw.is_null() {
            return Err(error_of(raw));
        }
        Ok(Player { raw, height: 0, borrowed: PhantomData })
    }

    /// Opens the bytes of a `.zsc` file in place; their address must be a multiple of 4 ([`include_scene`]). Every byte
    /// is checked, so any bytes are safe.
    pub fn open(&mut self, scene: &'a [u8]) -> Result<(), Error> {
        let opened = unsafe { raw::zstrip_player_open(self.raw, scene.as_ptr(), scene.len()) };
        self.result(opened)
    }

    /// Plans a picture: the camera is fitted to the display, and the plan to the memory.
    pub fn fit(&mut self, width: u16, height: u16, format: Format, options: &FitOptions) -> Result<(), Error> {
        let options = raw::FitOptions {
            strip_rows: options.strip_rows,
            row_step: options.row_step.max(1),
            masked: options.masked.into(),
            tracks_changes: options.tracks_changes.into(),
        };
        self.height = height;
        let fitted = unsafe { raw::zstrip_player_fit_with(self.raw, width, height, format, &options) };
        self.result(fitted)
    }

    /// Draws a frame and passes its strips to `take`, from the top to the bottom.
    pub fn draw(&mut self, mut take: impl FnMut(Strip<'_>)) -> Result<(), Error> {
        self.begin()?;
        let mut y = 0;
        while y < self.height {
            let strip = self.strip(y)?;
            y = strip.area.top + strip.area.height;
            take(strip);
        }
        Ok(())
    }

    /// Begins a frame at the time and from the place that were set last, for the next three functions.
    pub fn begin(&mut self) -> Result<(), Error> {
        let begun = unsafe { raw::zstrip_player_begin(self.raw) };
        self.result(begun)
    }

    /// Draws the strip that has row `y` of the frame that was begun last. The strip that was drawn last is not drawn
    /// again.
    pub fn strip(&mut self, y: u16) -> Result<Strip<'_>, Error> {
        let mut strip = raw::Strip {
            left: 0,
            top: 0,
            width: 0,
            height: 0,
            pixels: ptr::null(),
            bytes: 0,
            mask: ptr::null(),
        };
        let drawn = unsafe { raw::zstrip_player_strip(self.raw, y, &mut strip) };
        self.result(drawn)?;
        // Pixels and mask stay as they are until the next call that draws, which needs `self`.
        Ok(unsafe { strip_of(&strip) })
    }

    /// Draws a rectangle of the frame that was begun last. `pixels` begins with its upper left pixel; its rows are
    /// `stride` bytes apart. `mask`: none, or the mask from that pixel on, and the distance of its rows.
    pub fn draw_area(
        &mut self,
        area: Area,
        pixels: &mut [u8],
        stride: usize,
        mask: Option<(&mut [u8], usize)>,
    ) -> Result<(), Error> {
        let (mask, mask_stride) = match mask {
            None => (ptr::null_mut(), 0),
            Some((mask, mask_stride)) => {
                let rows = usize::from(area.height).saturating_sub(1);
                let bytes = mask_stride.checked_mul(rows).and_then(|all| all.checked_add(area.width.into()));
                if bytes.map_or(true, |bytes| mask.len() < bytes) {
                    return Err(Error::new(b"the mask has fewer bytes than the rectangle: give it all of its rows"));
                }
                (mask.as_mut_ptr(), mask_stride)
            }
        };
        let drawn = unsafe {
            raw::zstrip_player_draw_area(
                self.raw,
                &area,
                pixels.as_mut_ptr(),
                pixels.len(),
                stride,
                mask,
                mask_stride,
            )
        };
        self.result(drawn)
    }

    /// Finds what a pixel of the picture shows, in the frame that was begun last.
    pub fn pick(&mut self, x: u16, y: u16) -> Result<Picked, Error> {
        let mut picked =
            raw::Picked { shown: Shown::Background, textured: 0, index: 0, triangle: 0, u: 0, v: 0 };
        let found = unsafe {
            raw::zstrip_player_pick(self.raw, ptr::addr_of!(raw::zstrip_rust_picker), x, y, &mut picked)
        };
        self.result(found)?;
        Ok(Picked {
            shown: picked.shown,
            index: picked.index,
            triangle: picked.triangle,
            texture: if picked.textured != 0 { Some((picked.u, picked.v)) } else { None },
        })
    }

    /// Returns a rectangle outside of which the frame that was begun last equals the frame that was begun when this
    /// function was called before; none if nothing changed; the whole picture after a fit.
    pub fn changed(&mut self) -> Option<Area> {
        let mut area = Area::default();
        unsafe { raw::zstrip_player_changed(self.raw, &mut area) };
        if area.width > 0 && area.height > 0 {
            Some(area)
        } else {
            None
        }
    }

    /// Plays a clip from its beginning, over and over or once. During `fade` milliseconds the clips that play go on and
    /// become this one.
    pub fn play_clip(&mut self, clip: usize, fade: u16, loops: bool) -> Result<(), Error> {
        let plays = unsafe { raw::zstrip_player_play_clip(self.raw, clip, fade, loops.into()) };
        self.result(plays)
    }

    /// Returns the clips of the open scene.
    pub fn clips(&self) -> impl Iterator<Item = Clip<'_>> + '_ {
        let count = unsafe { raw::zstrip_player_clips(self.raw) };
        (0..count).map(move |clip| unsafe {
            Clip {
                name: str::from_utf8(bytes_of(raw::zstrip_player_clip_name(self.raw, clip))).unwrap_or(""),
                milliseconds: raw::zstrip_player_clip_time(self.raw, clip),
            }
        })
    }

    /// Returns the number of the next event that the clip that was chosen last has reached since the call before. Call
    /// it after `play` until there is none.
    pub fn poll_event(&mut self) -> Option<u16> {
        let mut number = 0;
        if unsafe { raw::zstrip_player_poll_event(self.raw, &mut number) } != 0 {
            Some(number)
        } else {
            None
        }
    }

    /// Returns the number of the first clip of this name.
    pub fn find_clip(&self, name: &str) -> Option<usize> {
        self.clips().position(|clip| clip.name == name)
    }

    /// Sets the time, in milliseconds of any clock. After the first call the animation runs; a scene without an
    /// animation rotates.
    pub fn play(&mut self, milliseconds: u32) {
        unsafe { raw::zstrip_player_play(self.raw, milliseconds) }
    }
    /// Returns the time, in milliseconds from the beginning of the motion or of the clip that was chosen last.
    pub fn time(&self) -> u32 {
        unsafe { raw::zstrip_player_time(self.raw) }
    }
    /// Returns how long the motion takes, in milliseconds, at least 1.
    pub fn period(&mut self) -> u32 {
        unsafe { raw::zstrip_player_period(self.raw) }
    }
    /// Pauses the motion, or continues it.
    pub fn hold(&mut self, held: bool) {
        unsafe { raw::zstrip_player_hold(self.raw, held.into()) }
    }
    /// Sets the motion to a time, in milliseconds from its beginning. A fade ends.
    pub fn seek(&mut self, milliseconds: u32) {
        unsafe { raw::zstrip_player_seek(self.raw, milliseconds) }
    }
    /// Moves the camera around the point that it looks at; 65536 is 360 degrees; 0, 0 is the baked position.
    pub fn orbit(&mut self, right: u16, up: u16) {
        unsafe { raw::zstrip_player_orbit(self.raw, right, up) }
    }
    /// Enlarges the picture; 100 is the baked size.
    pub fn zoom(&mut self, percent: u16) {
        unsafe { raw::zstrip_player_zoom(self.raw, percent) }
    }
    /// Replaces the background of the scene by 0xRRGGBB; none shows the baked one again.
    pub fn background(&mut self, colour: Option<u32>) {
        let colour = colour.map_or(BAKED_BACKGROUND, |colour| colour & 0xFF_FFFF);
        unsafe { raw::zstrip_player_background(self.raw, colour) }
    }
    /// Shows the first 24 bytes of `text`; needs the feature `overlay`.
    pub fn show_text(&mut self, text: &str) {
        let mut bytes = [0; MAX_TEXT + 1];
        let count = text.len().min(MAX_TEXT);
        bytes[..count].copy_from_slice(&text.as_bytes()[..count]);
        unsafe { raw::zstrip_player_show_text(self.raw, bytes.as_ptr(), 0) }
    }

    fn result(&mut self, right: raw::Int) -> Result<(), Error> {
        if right != 0 {
            Ok(())
        } else {
            Err(error_of(self.raw))
        }
    }
}

fn error_of(player: *mut raw::Opaque) -> Error {
    // The message is valid until the next call, and copied before.
    Error::new(unsafe { bytes_of(raw::zstrip_player_error(player)) })
}

/// Returns the bytes of a text that ends with a 0; none of a null pointer.
unsafe fn bytes_of<'t>(text: *const u8) -> &'t [u8] {
    if text.is_null() {
        return &[];
    }
    let mut bytes = 0;
    while *text.add(bytes) != 0 {
        bytes += 1;
    }
    slice::from_raw_parts(text, bytes)
}

/// Returns the strip as slices, which live as long as the caller says.
unsafe fn strip_of<'p>(strip: &raw::Strip) -> Strip<'p> {
    let pixels = usize::from(strip.width) * usize::from(strip.height);
    Strip {
        area: Area { left: strip.left, top: strip.top, width: strip.width, height: strip.height },
        pixels: slice::from_raw_parts(strip.pixels, strip.bytes),
        mask: if strip.mask.is_null() { None } else { Some(slice::from_raw_parts(strip.mask, pixels)) },
    }
}
