<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Exception\ExternalPartException;

/** What a file under a pattern's name is, by its first line and its length. */
enum PatternState
{
    /** The wanted pattern, whole. */
    case Good;

    /** No file. */
    case Missing;

    /** A pattern of MSISF, but damaged, of another format, or made from other samples: make it again. */
    case Outdated;

    /** Something that MSISF has not written: leave it alone. */
    case Foreign;

    /**
     * Looks at a file; one read, whatever its size.
     *
     * @param string $header the header that is wanted, without length
     */
    public static function inspect(string $path, string $header): self
    {
        clearstatcache(true, $path);
        if (!file_exists($path)) {
            return self::Missing;
        }
        $size = strlen($header) + PatternHeader::LENGTH_DIGITS + 1;
        $file = is_file($path) ? @fopen($path, 'rb') : false;
        if ($file === false) {
            throw new ExternalPartException(
                "$path: can't be read. Move it away, or choose another pattern repository.",
            );
        }
        try {
            $start = (string) stream_get_contents($file, $size);
            $length = fstat($file)['size'];
        } finally {
            fclose($file);
        }

        return match (true) {
            $start === $header . PatternHeader::length($length) . "\n" => self::Good,
            self::isOurs($start) => self::Outdated,
            default => self::Foreign,
        };
    }

    /** It has our mark, or as much of it as there are bytes; after a power cut a file can also be empty or all zeros. */
    private static function isOurs(string $start): bool
    {
        $common = min(strlen(PatternHeader::MARK), strlen($start));

        return strncmp($start, PatternHeader::MARK, $common) === 0 || trim($start, "\0") === '';
    }
}
