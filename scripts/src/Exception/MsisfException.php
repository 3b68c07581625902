<?php

declare(strict_types=1);

namespace Msisf\Scripts\Exception;

use RuntimeException;
use Throwable;

/** An expected failure: one line that says what is wrong, where, and what to do; it never needs a stack trace. */
abstract class MsisfException extends RuntimeException
{
    final public function __construct(string $message, ?Throwable $previous = null)
    {
        parent::__construct(preg_replace('/\s+/', ' ', trim($message)) ?? $message, 0, $previous);
    }

    /** Exit code of the script when this failure ends it; the same as those of msis. */
    abstract public function exitCode(): int;
}
