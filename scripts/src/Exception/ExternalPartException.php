<?php

declare(strict_types=1);

namespace Msisf\Scripts\Exception;

use Throwable;

/** The database, the disk or another part that is not ours failed or is missing. */
final class ExternalPartException extends MsisfException
{
    public function exitCode(): int
    {
        return 3;
    }

    public static function database(string $problem, ?Throwable $previous = null): self
    {
        return new self("database: $problem", $previous);
    }
}
