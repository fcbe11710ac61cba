//! The declarations of `zstrip_player.h`.
use core::marker::{PhantomData, PhantomPinned};

/// `int` of every processor that zstrip draws on.
pub type Int = i32;

/// A type of which only addresses are used.
#[repr(C)]
pub struct Opaque {
    bytes: [u8; 0],
    not_shared: PhantomData<(*mut u8, PhantomPinned)>,
}

/// `zstrip_pipeline` and `zstrip_picker`: a pointer to a function each. build.rs writes one of both.
#[repr(C)]
pub struct Choice {
    choose: Option<extern "C" fn()>,
}

#[repr(C)]
pub struct Strip {
    pub left: u16,
    pub top: u16,
    pub width: u16,
    pub height: u16,
    pub pixels: *const u8,
    pub bytes: usize,
    pub mask: *const u8,
}

#[repr(C)]
pub struct FitOptions {
    pub strip_rows: u16,
    pub row_step: u16,
    pub masked: Int,
    pub tracks_changes: Int,
}

#[repr(C)]
pub struct Picked {
    pub shown: crate::Shown,
    pub textured: Int,
    pub index: u16,
    pub triangle: u32,
    pub u: u16,
    pub v: u16,
}

extern "C" {
    pub static zstrip_rust_pipeline: Choice;
    pub static zstrip_rust_picker: Choice;

    pub fn zstrip_player_in(memory: *mut u8, bytes: usize, pipeline: *const Choice) -> *mut Opaque;
    pub fn zstrip_player_open(player: *mut Opaque, scene: *const u8, bytes: usize) -> Int;
    pub fn zstrip_player_fit_with(
        player: *mut Opaque,
        width: u16,
        height: u16,
        format: crate::Format,
        options: *const FitOptions,
    ) -> Int;
    pub fn zstrip_player_begin(player: *mut Opaque) -> Int;
    pub fn zstrip_player_strip(player: *mut Opaque, y: u16, strip: *mut Strip) -> Int;
    pub fn zstrip_player_draw_area(
        player: *mut Opaque,
        area: *const crate::Area,
        pixels: *mut u8,
        bytes: usize,
        stride: usize,
        mask: *mut u8,
        mask_stride: usize,
    ) -> Int;
    pub fn zstrip_player_pick(
        player: *mut Opaque,
        picker: *const Choice,
        x: u16,
        y: u16,
        picked: *mut Picked,
    ) -> Int;
    pub fn zstrip_player_play_clip(player: *mut Opaque, clip: usize, fade: u16, loops: Int) -> Int;
    pub fn zstrip_player_clips(player: *const Opaque) -> usize;
    pub fn zstrip_player_clip_name(player: *const Opaque, clip: usize) -> *const u8;
    pub fn zstrip_player_clip_time(player: *const Opaque, clip: usize) -> u32;
    pub fn zstrip_player_poll_event(player: *mut Opaque, number: *mut u16) -> Int;
    pub fn zstrip_player_changed(player: *mut Opaque, area: *mut crate::Area);
    pub fn zstrip_player_background(player: *mut Opaque, colour: u32);
    pub fn zstrip_player_play(player: *mut Opaque, milliseconds: u32);
    pub fn zstrip_player_time(player: *const Opaque) -> u32;
    pub fn zstrip_player_period(player: *mut Opaque) -> u32;
    pub fn zstrip_player_hold(player: *mut Opaque, held: Int);
    pub fn zstrip_player_seek(player: *mut Opaque, milliseconds: u32);
    pub fn zstrip_player_orbit(player: *mut Opaque, right: u16, up: u16);
    pub fn zstrip_player_zoom(player: *mut Opaque, percent: u16);
    pub fn zstrip_player_show_text(player: *mut Opaque, text: *const u8, with_rate: Int);
    pub fn zstrip_player_error(player: *mut Opaque) -> *const u8;
}
