<?php

declare(strict_types=1);

namespace Msisf\Scripts\Exception;

/** Wrong, missing or contradicting options. */
final class UsageException extends MsisfException
{
    public function exitCode(): int
    {
        return 1;
    }

    public static function badValue(string $option, string $value, string $need): self
    {
        return new self("--$option=$value: $need.");
    }

    public static function missing(string $option, string $valueName): self
    {
        return new self("--$option is missing. Give --$option $valueName; --help lists the options.");
    }
}
