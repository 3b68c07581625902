<?php

declare(strict_types=1);

namespace Msisf\Scripts\Exception;

use Throwable;

/** A file or a value does not hold what it should. */
final class BadInputException extends MsisfException
{
    public function exitCode(): int
    {
        return 2;
    }

    public static function inFile(string $path, string $problem, ?Throwable $previous = null): self
    {
        return new self("$path: $problem", $previous);
    }

    public static function atLine(string $path, int $line, string $problem): self
    {
        return new self("$path, line $line: $problem");
    }
}
