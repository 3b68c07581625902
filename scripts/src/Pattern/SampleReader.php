<?php

declare(strict_types=1);

namespace Msisf\Scripts\Pattern;

use Msisf\Scripts\Database\Connection;
use Msisf\Scripts\Database\Statement;
use Msisf\Scripts\Exception\ExternalPartException;
use PDO;
use PDOException;
use PDOStatement;

/** Reads long results without a copy of them in PDO's own buffer, which would cost a third more time. */
final class SampleReader
{
    /**
     * @param list<int|float|string> $values for the question marks
     * @param int                    $mode   PDO::FETCH_COLUMN or PDO::FETCH_KEY_PAIR
     *
     * @return array<int, float>
     * @throws ExternalPartException the database failed
     */
    public static function fetch(Connection $connection, string $sql, array $values, int $mode): array
    {
        return $connection->wrap(static function () use ($connection, $sql, $values, $mode): array {
            $pdo = $connection->pdo();
            $pdo->setAttribute(PDO::MYSQL_ATTR_USE_BUFFERED_QUERY, false);
            try {
                $statement = $pdo->prepare($sql);
                Statement::bind($statement, $values);
                $statement->execute();

                $rows = $statement->fetchAll($mode);
                self::requireEnd($statement);

                return $rows;
            } finally {
                $pdo->setAttribute(PDO::MYSQL_ATTR_USE_BUFFERED_QUERY, true);
            }
        });
    }

    /** fetchAll() throws nothing when the result breaks off: the server went away, or somebody stopped the query. */
    private static function requireEnd(PDOStatement $statement): void
    {
        [$state, $number, $message] = [...$statement->errorInfo(), null, null];
        if ($state !== PDO::ERR_NONE) {
            $failure = new PDOException((string) $message);
            $failure->errorInfo = [$state, $number, $message];
            throw $failure;
        }
    }
}
