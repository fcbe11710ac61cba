//! Draws frames of a baked scene on a PC, the pixels that a display would get: RGB565, rows from the top.
//!     picture SCENE.zsc WIDTH HEIGHT FRAMES [CLIP] > frames.raw
//! The frames show the motion once. CLIP: the name of an animation of the scene.
use std::io::{stdout, Write};
use std::{env, error, fs, process};

/// Words and bytes in the memory of a file need not lie at a multiple of 4; those of words do.
fn scene_in(words: &mut Vec<u32>, bytes: &[u8]) {
    words.extend(bytes.chunks(4).map(|four| {
        let mut word = [0; 4];
        word[..four.len()].copy_from_slice(four);
        u32::from_ne_bytes(word)
    }));
}

fn show(arguments: &[String]) -> Result<(), Box<dyn error::Error>> {
    let file = fs::read(&arguments[0])?;
    let (width, height): (u16, u16) = (arguments[1].parse()?, arguments[2].parse()?);
    let frames: u32 = arguments[3].parse()?;
    let mut words = Vec::new();
    scene_in(&mut words, &file);
    let scene = unsafe { std::slice::from_raw_parts(words.as_ptr().cast(), file.len()) };

    let mut memory = vec![0; 1 << 20];
    let say = |fault: zstrip::Error| fault.to_string();
    let mut player = zstrip::Player::new(&mut memory).map_err(say)?;
    player.open(scene).map_err(say)?;
    player.fit(width, height, zstrip::Format::Rgb565, &zstrip::FitOptions::default()).map_err(say)?;
    if let Some(name) = arguments.get(4) {
        let clip = player.find_clip(name).ok_or("the scene has no clip of this name")?;
        player.play_clip(clip, 0, true).map_err(say)?;
    }
    for frame in 0..frames {
        let time = u64::from(player.period()) * u64::from(frame) / u64::from(frames);
        player.seek(time as u32);
        let mut sent = Ok(());
        player
            .draw(|strip| {
                if sent.is_ok() {
                    sent = stdout().write_all(strip.pixels);
                }
            })
            .map_err(say)?;
        sent?;
    }
    Ok(())
}

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    if arguments.len() < 4 || arguments.len() > 5 {
        eprintln!("picture SCENE.zsc WIDTH HEIGHT FRAMES [CLIP] > frames.raw");
        process::exit(2);
    }
    if let Err(fault) = show(&arguments) {
        eprintln!("picture: {}", fault);
        process::exit(1);
    }
}
