<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\ExternalPartException;
use Msisf\Scripts\IO\AtomicFile;

/**
 * The folder of pattern files: [root]/[res]/pattern_LDEM_[res]_lat_[a]_[b]_lon_[c]_[d].inc. Several processes, also of
 * msis, may use one repository at once: a file appears whole under its name, and two that make the same one make the
 * same bytes.
 */
final class PatternRepository
{
    /** Seconds; a pattern takes under a second. */
    private const STALE_AGE = 3600;

    private readonly string $folder;

    public function __construct(string $root, private readonly int $pixelsPerDegree)
    {
        $this->folder = rtrim($root, '/\\') . "/$pixelsPerDegree";
    }

    /** The folder of the resolution's patterns. */
    public function folder(): string
    {
        return $this->folder;
    }

    /** The file of a tile's pattern. */
    public function pathOf(TileId $tile): string
    {
        return "$this->folder/pattern_LDEM_{$this->pixelsPerDegree}_{$tile->rangeText()}.inc";
    }

    public function makeFolder(): void
    {
        // Another process may make it between the two calls.
        if (!is_dir($this->folder) && !@mkdir($this->folder, 0o777, true) && !is_dir($this->folder)) {
            $reason = error_get_last()['message'] ?? '';
            throw new ExternalPartException("$this->folder: can't be made: $reason. Choose another --repository.");
        }
    }

    /**
     * Whether the tile's pattern has to be made.
     *
     * @param string $header the wanted header without length
     */
    public function needs(TileId $tile, string $header): bool
    {
        $path = $this->pathOf($tile);

        return match (PatternState::inspect($path, $header)) {
            PatternState::Good => false,
            PatternState::Missing, PatternState::Outdated => true,
            PatternState::Foreign => throw new BadInputException(
                "$path: has a pattern's name, but MSISF has not made it, so it stays as it is."
                . ' Move it away, or choose another --repository.',
            ),
        };
    }

    /** @param callable(resource): void $write writes the pattern */
    public function put(TileId $tile, callable $write): void
    {
        AtomicFile::write($this->pathOf($tile), $write);
    }

    /**
     * Removes what killed runs left. The age is taken by the file system's own clock, from the newest file of the folder,
     * so it holds for shared folders too, where neither our clock nor our process numbers mean anything.
     */
    public function removeStaleFiles(): void
    {
        $partials = glob("$this->folder/pattern_*" . AtomicFile::PARTIAL_MARK . '.inc') ?: [];
        if ($partials === []) {
            return;
        }
        $newest = max(array_map(self::modified(...), glob("$this->folder/pattern_*.inc") ?: [0]));
        foreach ($partials as $partial) {
            if ($newest - self::modified($partial) > self::STALE_AGE) {
                @unlink($partial); // another user's leftover is theirs to remove
            }
        }
    }

    /** Seconds since 1970; a file that has just gone counts as new. */
    private static function modified(string $path): int
    {
        $time = @filemtime($path);

        return $time === false ? 0 : $time;
    }
}
