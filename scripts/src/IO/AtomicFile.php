<?php

declare(strict_types=1);

namespace Msisf\Scripts\IO;

use Msisf\Scripts\Exception\ExternalPartException;

/** Writes a file whole or not at all: under a name of its own in the same folder, then renamed. */
final class AtomicFile
{
    /** What the names of unfinished files end in, before their extension; the C# program's are the same. */
    public const PARTIAL_MARK = '.partial';

    /**
     * Writes one file; an existing file is replaced at the end, in one step. It is not flushed to the disk: for files that
     * can be made again and carry their own check.
     *
     * @param callable(resource): void $write writes the content with self::put; the stream can seek
     */
    public static function write(string $path, callable $write): void
    {
        $temporary = self::temporaryNameFor($path);
        $file = @fopen($temporary, 'xb');
        if ($file === false) {
            throw self::failure($path);
        }
        $done = false;
        try {
            $write($file);
            $done = fclose($file) && @rename($temporary, $path);
            if (!$done) {
                throw self::failure($path);
            }
        } finally {
            if (!$done) {
                @unlink($temporary);
            }
        }
    }

    /**
     * Writes all of a text, or fails.
     *
     * @param resource $file
     */
    public static function put($file, string $text): void
    {
        if (@fwrite($file, $text) !== strlen($text)) {
            throw self::failure(stream_get_meta_data($file)['uri']);
        }
    }

    private static function temporaryNameFor(string $path): string
    {
        $parts = pathinfo($path);
        $unique = sprintf('.%d-%s', getmypid(), bin2hex(random_bytes(16)));
        $extension = isset($parts['extension']) ? ".{$parts['extension']}" : '';

        return "{$parts['dirname']}/{$parts['filename']}$unique" . self::PARTIAL_MARK . $extension;
    }

    private static function failure(string $path): ExternalPartException
    {
        $reason = error_get_last()['message'] ?? 'no reason is known';

        return new ExternalPartException("$path: can't be written: $reason");
    }
}
