<?php

declare(strict_types=1);

namespace Msisf\Scripts\Console;

use Msisf\Scripts\Exception\UsageException;

/** Reads the arguments of an entry script; anything that is not declared is refused. */
final class OptionParser
{
    private const HELP_COLUMN = 30;

    /** @var array<string, Option> by name */
    private readonly array $options;

    /**
     * @param string $usage what the script does and how it is called, for --help
     * @param list<Option> $options
     * @param string|null $operandName name of the arguments without dashes; null if there are none
     */
    public function __construct(
        private readonly string $usage,
        array $options,
        private readonly ?string $operandName = null,
    ) {
        $byName = [];
        foreach ([...$options, Option::flag('help', 'Show this text.')] as $option) {
            $byName[$option->name] = $option;
        }
        $this->options = $byName;
    }

    /**
     * @param list<string> $arguments without the script's name
     * @throws UsageException an argument is unknown, given twice, or lacks its value
     */
    public function parse(array $arguments): ParsedOptions
    {
        $values = [];
        $operands = [];
        for ($i = 0; $i < count($arguments); $i++) {
            $argument = $arguments[$i];
            if ($argument === '--') {
                array_push($operands, ...array_slice($arguments, $i + 1));
                break;
            }
            if (!str_starts_with($argument, '-') || $argument === '-') {
                $operands[] = $argument;
                continue;
            }
            [$name, $value] = [...explode('=', $argument, 2), null];
            $option = $this->find((string) $name);
            if (array_key_exists($option->name, $values)) {
                throw new UsageException("--$option->name is given twice. Give it once.");
            }
            if ($option->valueName !== null && $value === null) {
                $value = $arguments[++$i] ?? throw UsageException::missing($option->name, $option->valueName);
                if (str_starts_with($value, '--')) {
                    throw new UsageException("--$option->name has no value ($value follows). Give --$option->name=$option->valueName.");
                }
            } elseif ($option->valueName === null && $value !== null) {
                throw UsageException::badValue($option->name, $value, 'this option has no value');
            }
            $values[$option->name] = $value ?? '';
        }
        if ($operands !== [] && $this->operandName === null) {
            throw new UsageException("'$operands[0]' is not an option. --help lists the options.");
        }

        return new ParsedOptions($this->options, $values, $operands);
    }

    public function help(): string
    {
        $text = $this->usage . "\n\nOptions:\n";
        foreach ($this->options as $option) {
            $form = '  --' . $option->name . ($option->valueName === null ? '' : ' ' . $option->valueName);
            $default = $option->default === null ? '' : " (default: $option->default)";
            $help = wordwrap($option->help . $default, 100 - self::HELP_COLUMN, "\n" . str_repeat(' ', self::HELP_COLUMN));
            $gap = strlen($form) < self::HELP_COLUMN - 1
                ? str_repeat(' ', self::HELP_COLUMN - strlen($form))
                : "\n" . str_repeat(' ', self::HELP_COLUMN);
            $text .= $form . $gap . $help . "\n";
        }

        return $text;
    }

    private function find(string $argument): Option
    {
        return (str_starts_with($argument, '--') ? $this->options[substr($argument, 2)] ?? null : null)
            ?? throw new UsageException("$argument is not an option. --help lists the options.");
    }
}
