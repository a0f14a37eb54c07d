//! Counts of worn phrases and sentence lengths, to hold this project beside others.

use std::path::PathBuf;

use relief_words::phrases::PHRASES;
use relief_words::sentences::Lengths;
use relief_words::tree::Counts;

/// Prints the counts of each folder.
pub fn print(folders: &[PathBuf]) -> Result<(), String> {
    for folder in folders {
        let counts = Counts::of(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        println!("{}", folder.display());
        println!(
            "  comments: {} lines, {} worn phrases, {:.2} in 1,000 lines",
            counts.comment_lines,
            counts.in_comments.iter().sum::<usize>(),
            counts.per_thousand()
        );
        println!("  literals: {} worn phrases", counts.in_literals.iter().sum::<usize>());
        for (phrase, words) in PHRASES.iter().enumerate() {
            println!("    {words:16} {:4} {:4}", counts.in_comments[phrase], counts.in_literals[phrase]);
        }
        for (name, Lengths { count, median, ninety, longest }) in &counts.pages {
            println!(
                "  {name}: {count} sentences; words: {median} at the median, {ninety} at the 90th \
                 percentile, {longest} at most"
            );
        }
    }
    Ok(())
}
