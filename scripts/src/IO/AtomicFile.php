<?php

declare(strict_types=1);

namespace Msisf\Scripts\IO;

use Msisf\Scripts\Exception\ExternalPartException;

/**
 * A file that appears whole or not at all: written under a name of its own in the same folder, then renamed. It is not
 * flushed to the disk: for files that can be made again and carry their own check.
 */
final class AtomicFile
{
    /** What the names of unfinished files end in, before their extension; those of msis are the same. */
    public const PARTIAL_MARK = '.partial';

    private readonly string $temporary;

    /** @var resource|null */
    private mixed $file;

    private int $nanoseconds = 0;

    /** @throws ExternalPartException the folder refuses */
    public function __construct(private readonly string $path)
    {
        $parts = pathinfo($path);
        $unique = sprintf('.%d-%s', getmypid(), bin2hex(random_bytes(16)));
        $extension = isset($parts['extension']) ? ".{$parts['extension']}" : '';
        $this->temporary = "{$parts['dirname']}/{$parts['filename']}$unique" . self::PARTIAL_MARK . $extension;
        $this->file = $this->timed(fn (): mixed => @fopen($this->temporary, 'xb')) ?: throw $this->failure();
    }

    /** What was not committed goes away. */
    public function __destruct()
    {
        if ($this->file !== null) {
            fclose($this->file);
            @unlink($this->temporary);
        }
    }

    /** @throws ExternalPartException the disk is full, for example */
    public function put(string $text): void
    {
        if ($this->timed(fn (): int|false => @fwrite($this->file, $text)) !== strlen($text)) {
            throw $this->failure();
        }
    }

    /** Writes over what stands at a place, and goes on there. */
    public function putAt(int $position, string $text): void
    {
        fseek($this->file, $position);
        $this->put($text);
    }

    /** Gives the file its name, in one step; one that had it is replaced. */
    public function commit(): void
    {
        $file = $this->file;
        $this->file = null;
        $done = $this->timed(fn (): bool => @fclose($file) && @rename($this->temporary, $this->path));
        if (!$done) {
            $failure = $this->failure();
            @unlink($this->temporary);
            throw $failure;
        }
    }

    /** Seconds that the file system took. */
    public function seconds(): float
    {
        return $this->nanoseconds / 1e9;
    }

    private function timed(callable $work): mixed
    {
        $start = hrtime(true);
        $result = $work();
        $this->nanoseconds += hrtime(true) - $start;

        return $result;
    }

    private function failure(): ExternalPartException
    {
        // "fopen(long name): Failed to open stream: No space left on device": the last part is the reason.
        $message = error_get_last()['message'] ?? 'the reason is not known';
        $reason = substr((string) strrchr(": $message", ': '), 1);

        return new ExternalPartException("$this->path: can't be written: " . trim($reason) . '.');
    }
}
