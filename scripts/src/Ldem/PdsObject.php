<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

use Msisf\Scripts\Exception\BadInputException;

/**
 * An OBJECT or GROUP of a PDS3 label, or the label itself: keywords with their values, and objects inside it. Names are the same in small
 * letters and in capitals.
 */
final class PdsObject
{
    /** @var array<string, PdsValue> */
    private array $values = [];

    /** @var array<string, PdsValue> second values of keywords, which differ from the first */
    private array $contradictions = [];

    /** @var list<PdsObject> */
    private array $children = [];

    /**
     * @param string $file name of the label's file for messages
     * @param int $line where it begins, from 1
     */
    public function __construct(private readonly string $file, public readonly string $name, public readonly int $line)
    {
    }

    /**
     * The value of a keyword of this object itself; null if it has none.
     *
     * @throws BadInputException the object has it twice, with values that contradict each other
     */
    public function find(string $keyword): ?PdsValue
    {
        $value = $this->values[strtoupper($keyword)] ?? null;
        $second = $this->contradictions[strtoupper($keyword)] ?? null;
        if ($second !== null) {
            throw $this->unfit($keyword, $second, "line $value->line of the same object says $value");
        }

        return $value;
    }

    /** The first object of a name, in the order of the label, however deep; null if there is none. */
    public function findObject(string $name): ?self
    {
        foreach ($this->children as $child) {
            $found = strcasecmp($child->name, $name) === 0 ? $child : $child->findObject($name);
            if ($found !== null) {
                return $found;
            }
        }

        return null;
    }

    /** @throws BadInputException the keyword is missing */
    public function required(string $keyword): PdsValue
    {
        return $this->find($keyword) ?? throw BadInputException::inFile(
            $this->file,
            "$this->name has no $keyword. Get the label again from the archive that holds the product."
        );
    }

    /** @throws BadInputException the keyword is missing, empty or a sequence */
    public function requiredText(string $keyword): string
    {
        $value = $this->required($keyword);
        if ($value->items !== null || $value->text === '') {
            throw $this->unfit($keyword, $value, 'one text is needed');
        }

        return (string) $value;
    }

    /**
     * @param string|null $unit one of PdsUnit, which its unit must be if it has one
     * @throws BadInputException it is missing, no finite number, or has another unit
     */
    public function requiredNumber(string $keyword, ?string $unit = null): float
    {
        return $this->number($keyword, $this->required($keyword), $unit);
    }

    /**
     * @return float|null null if it is missing or 'N/A'
     * @throws BadInputException it is no finite number, or has another unit
     */
    public function optionalNumber(string $keyword, ?string $unit = null): ?float
    {
        $value = $this->find($keyword);

        return $value === null || $value->word() === 'N/A' ? null : $this->number($keyword, $value, $unit);
    }

    /** @throws BadInputException it is missing, no whole number, or out of range */
    public function requiredInteger(string $keyword, int $minimum, int $maximum): int
    {
        return $this->integer($keyword, $this->required($keyword), $minimum, $maximum);
    }

    /**
     * @return int|null null if it is missing
     * @throws BadInputException it is no whole number, or out of range
     */
    public function optionalInteger(string $keyword, int $minimum, int $maximum): ?int
    {
        $value = $this->find($keyword);

        return $value === null ? null : $this->integer($keyword, $value, $minimum, $maximum);
    }

    /** The error for a value that can't be. */
    public function unfit(string $keyword, PdsValue $value, string $need): BadInputException
    {
        return BadInputException::atLine($this->file, $value->line, "$keyword = $value; $need.");
    }

    /** Adds a keyword while the label is read. A second value counts only when somebody asks for the keyword. */
    public function addValue(string $keyword, PdsValue $value): void
    {
        $name = strtoupper($keyword);
        $this->values[$name] ??= $value;
        if ((string) $this->values[$name] !== (string) $value) {
            $this->contradictions[$name] ??= $value;
        }
    }

    public function addObject(self $child): void
    {
        $this->children[] = $child;
    }

    private function number(string $keyword, PdsValue $value, ?string $unit): float
    {
        $isNumber = preg_match('/^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$/D', $value->text) === 1;
        if ($value->items !== null || $value->isQuoted || !$isNumber || !is_finite((float) $value->text)) {
            throw $this->unfit($keyword, $value, 'a finite number is needed');
        }
        if ($unit !== null && $value->unit !== null && PdsUnit::of($value->unit) !== $unit) {
            throw $this->unfit($keyword, $value, "the unit <$unit> is needed");
        }

        return (float) $value->text;
    }

    private function integer(string $keyword, PdsValue $value, int $minimum, int $maximum): int
    {
        $number = $this->number($keyword, $value, unit: null);
        if ($number !== floor($number) || $number < $minimum || $number > $maximum) {
            throw $this->unfit($keyword, $value, "a whole number from $minimum to $maximum is needed");
        }

        return (int) $number;
    }
}
