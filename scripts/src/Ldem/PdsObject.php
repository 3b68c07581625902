<?php

declare(strict_types=1);

namespace Msisf\Scripts\Ldem;

use Msisf\Scripts\Exception\BadInputException;

/** An OBJECT or GROUP of a PDS3 label, or the label itself: keywords with their values, and objects inside it. */
final class PdsObject
{
    /** @var array<string, PdsValue> */
    private array $values = [];

    /** @var list<PdsObject> */
    private array $children = [];

    /**
     * @param string $file name of the label's file for messages
     * @param int $line where it begins, from 1
     */
    public function __construct(private readonly string $file, public readonly string $name, public readonly int $line)
    {
    }

    /** The value of a keyword of this object itself; null if it has none. */
    public function find(string $keyword): ?PdsValue
    {
        return $this->values[$keyword] ?? null;
    }

    /** The first object of a name, in the order of the label, however deep; null if there is none. */
    public function findObject(string $name): ?self
    {
        foreach ($this->children as $child) {
            $found = $child->name === $name ? $child : $child->findObject($name);
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
     * @param list<string> $units spellings of its unit, if it has one
     * @throws BadInputException it is missing, no finite number, or has another unit
     */
    public function requiredNumber(string $keyword, array $units = []): float
    {
        return $this->number($keyword, $this->required($keyword), $units);
    }

    /**
     * @param list<string> $units
     * @return float|null null if it is missing or 'N/A'
     * @throws BadInputException it is no finite number, or has another unit
     */
    public function optionalNumber(string $keyword, array $units = []): ?float
    {
        $value = $this->find($keyword);

        return $value === null || $value->text === 'N/A' ? null : $this->number($keyword, $value, $units);
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

    /** @throws BadInputException the object has the keyword already, with another value */
    public function addValue(string $keyword, PdsValue $value): void
    {
        $earlier = $this->values[$keyword] ??= $value;
        if ((string) $earlier !== (string) $value) {
            throw $this->unfit($keyword, $value, "line $earlier->line of the same object says $earlier");
        }
    }

    public function addObject(self $child): void
    {
        $this->children[] = $child;
    }

    /** @param list<string> $units */
    private function number(string $keyword, PdsValue $value, array $units): float
    {
        $isNumber = preg_match('/^[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?$/D', $value->text) === 1;
        if ($value->items !== null || $value->isQuoted || !$isNumber || !is_finite((float) $value->text)) {
            throw $this->unfit($keyword, $value, 'a finite number is needed');
        }
        if ($units !== [] && $value->unit !== null && !in_array(strtolower($value->unit), $units, true)) {
            throw $this->unfit($keyword, $value, "the unit <$units[0]> is needed");
        }

        return (float) $value->text;
    }

    private function integer(string $keyword, PdsValue $value, int $minimum, int $maximum): int
    {
        $number = $this->number($keyword, $value, []);
        if ($number !== floor($number) || $number < $minimum || $number > $maximum) {
            throw $this->unfit($keyword, $value, "a whole number from $minimum to $maximum is needed");
        }

        return (int) $number;
    }
}
