<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Closure;
use PDO;
use PDOStatement;

/** A prepared statement whose values are bound with their type. */
final class Statement
{
    /** @param Closure(Closure): mixed $wrap turns failures of PDO into ours */
    public function __construct(private readonly PDOStatement $statement, private readonly Closure $wrap)
    {
    }

    /**
     * @param array<int|string, int|float|string|null> $values a list for "?", by name for ":name"
     * @return int rows changed
     */
    public function execute(array $values = []): int
    {
        return ($this->wrap)(function () use ($values): int {
            self::bind($this->statement, $values);
            $this->statement->execute();

            return $this->statement->rowCount();
        });
    }

    /** @param array<int|string, int|float|string|null> $values */
    public static function bind(PDOStatement $statement, array $values): void
    {
        foreach ($values as $name => $value) {
            // PDO has no type for doubles: as text with precision -1 they arrive without loss.
            $type = is_int($value) ? PDO::PARAM_INT : ($value === null ? PDO::PARAM_NULL : PDO::PARAM_STR);
            $statement->bindValue(is_int($name) ? $name + 1 : $name, $value, $type);
        }
    }
}
