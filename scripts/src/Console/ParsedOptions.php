<?php

declare(strict_types=1);

namespace Msisf\Scripts\Console;

use LogicException;
use Msisf\Scripts\Exception\UsageException;

/** What was given on the command line. */
final class ParsedOptions
{
    /**
     * @param array<string, Option> $declared by name
     * @param array<string, string> $given by name; a flag's value is ''
     * @param list<string> $operands arguments without dashes
     */
    public function __construct(
        private readonly array $declared,
        private readonly array $given,
        public readonly array $operands,
    ) {
    }

    public function has(string $name): bool
    {
        $this->declaration($name);

        return array_key_exists($name, $this->given);
    }

    /** The value, or the default; null if there is neither. */
    public function text(string $name): ?string
    {
        return $this->given[$name] ?? $this->declaration($name)->default;
    }

    /** @throws UsageException the option is missing and has no default */
    public function requiredText(string $name): string
    {
        return $this->text($name) ?? throw UsageException::missing($name, (string) $this->declaration($name)->valueName);
    }

    /** @throws UsageException the value is no whole number within the limits */
    public function integer(string $name, int $minimum, int $maximum): int
    {
        $text = $this->requiredText($name);
        $number = preg_match('/^[+-]?[0-9]{1,18}$/D', $text) === 1 ? (int) $text : null;
        if ($number === null || $number < $minimum || $number > $maximum) {
            throw UsageException::badValue($name, $text, "a whole number from $minimum to $maximum is needed");
        }

        return $number;
    }

    /**
     * @param list<string> $allowed
     * @throws UsageException the value is none of the allowed ones
     */
    public function choice(string $name, array $allowed): string
    {
        $text = $this->requiredText($name);
        if (!in_array($text, $allowed, true)) {
            throw UsageException::badValue($name, $text, 'one of ' . implode(', ', $allowed) . ' is needed');
        }

        return $text;
    }

    private function declaration(string $name): Option
    {
        return $this->declared[$name] ?? throw new LogicException("The option --$name is not declared.");
    }
}
