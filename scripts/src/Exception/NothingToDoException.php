<?php

declare(strict_types=1);

namespace Msisf\Scripts\Exception;

/** Valid input that asks for nothing. */
final class NothingToDoException extends MsisfException
{
    public function exitCode(): int
    {
        return 4;
    }
}
