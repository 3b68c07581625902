<?php

declare(strict_types=1);

namespace Msisf\Scripts\Console;

/** One option of an entry script, declared once with its help. */
final class Option
{
    private function __construct(
        public readonly string $name,
        public readonly ?string $valueName,
        public readonly string $help,
        public readonly ?string $default,
    ) {
    }

    /** An option that is given or not. */
    public static function flag(string $name, string $help): self
    {
        return new self($name, null, $help, null);
    }

    /** An option with a value: "--name VALUE" or "--name=VALUE". */
    public static function value(string $name, string $valueName, string $help, ?string $default = null): self
    {
        return new self($name, $valueName, $help, $default);
    }
}
