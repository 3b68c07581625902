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

    /** A new file that will replace the tile's pattern. */
    public function create(TileId $tile): AtomicFile
    {
        return new AtomicFile($this->pathOf($tile));
    }

    /**
     * Removes what killed runs left. The age is taken by the file system's own clock, from the newest file of the folder,
     * so it holds for shared folders too, where neither our clock nor our process numbers mean anything.
     */
    public function removeStaleFiles(): void
    {
        $newest = 0;
        $partials = [];
        foreach (@scandir($this->folder) ?: [] as $name) {
            $time = fnmatch('pattern_*.inc', $name) ? @filemtime("$this->folder/$name") : false;
            $newest = max($newest, (int) $time);
            if ($time !== false && str_ends_with($name, AtomicFile::PARTIAL_MARK . '.inc')) {
                $partials[$name] = $time;
            }
        }
        foreach ($partials as $name => $time) {
            if ($newest - $time > self::STALE_AGE) {
                @unlink("$this->folder/$name"); // another user's leftover is theirs to remove
            }
        }
    }
}
