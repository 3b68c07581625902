<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Closure;
use Msisf\Scripts\Exception\ExternalPartException;
use PDO;
use PDOException;
use PDOStatement;
use Throwable;

/** A connection with one character set, strict SQL mode and native prepared statements; every failure of PDO is wrapped. */
final class Connection
{
    private function __construct(
        private readonly PDO $pdo,
        public readonly ServerVersion $serverVersion,
        public readonly string $database,
        private readonly string $server,
    ) {
    }

    /**
     * @param bool $allowLocalFiles the server may ask this process for the stream of a LOAD DATA LOCAL
     * @throws ExternalPartException no server, no access, or a server of another version
     */
    public static function open(ConnectionSettings $settings, bool $allowLocalFiles = false): self
    {
        if (!extension_loaded('pdo_mysql')) {
            throw new ExternalPartException('PHP has no pdo_mysql. Install it (Debian: php-mysql).');
        }

        $pdo = DatabaseFailure::wrapConnecting($settings, static fn (): PDO => new PDO(
            $settings->dataSource(),
            $settings->user,
            $settings->password(),
            $settings->tls->pdoOptions() + [
                PDO::ATTR_ERRMODE => PDO::ERRMODE_EXCEPTION,
                PDO::ATTR_STRINGIFY_FETCHES => false,
                PDO::MYSQL_ATTR_LOCAL_INFILE => $allowLocalFiles,
                PDO::MYSQL_ATTR_MULTI_STATEMENTS => false,
            ],
        ));

        return DatabaseFailure::wrap($settings->server(), static function () use ($pdo, $settings): self {
            $version = ServerVersion::parse((string) $pdo->query('SELECT VERSION()')->fetchColumn());
            // Only now: a server that is too old for prepared statements can still say so.
            $pdo->setAttribute(PDO::ATTR_EMULATE_PREPARES, false);
            // READ COMMITTED: INSERT ... SELECT then locks nothing of what it reads.
            $pdo->exec("SET SESSION sql_mode = 'STRICT_ALL_TABLES,NO_ENGINE_SUBSTITUTION,ERROR_FOR_DIVISION_BY_ZERO'");
            $pdo->exec('SET SESSION TRANSACTION ISOLATION LEVEL READ COMMITTED');

            return new self($pdo, $version, $settings->database, $settings->server());
        });
    }

    /** Makes the database of the settings the current one. */
    public function useDatabase(): void
    {
        $this->execute("USE `$this->database`");
    }

    /** @param array<int|string, int|float|string|null> $values */
    public function execute(string $sql, array $values = []): int
    {
        return $this->wrap(fn (): int => $values === []
            ? (int) $this->pdo->exec($sql)
            : $this->run($sql, $values)->rowCount());
    }

    /** For statements that are run often: each run binds its values. */
    public function prepare(string $sql): Statement
    {
        return new Statement($this->wrap(fn (): PDOStatement => $this->pdo->prepare($sql)), $this->wrap(...));
    }

    /**
     * @param array<int|string, int|float|string|null> $values
     * @return list<array<string, int|float|string|null>> all rows
     */
    public function rows(string $sql, array $values = []): array
    {
        return $this->wrap(fn (): array => $this->run($sql, $values)->fetchAll(PDO::FETCH_ASSOC));
    }

    /**
     * @param array<int|string, int|float|string|null> $values
     * @return int|float|string|null first column of the first row; null also if there is no row
     */
    public function value(string $sql, array $values = []): int|float|string|null
    {
        return $this->wrap(function () use ($sql, $values): int|float|string|null {
            $row = $this->run($sql, $values)->fetch(PDO::FETCH_NUM);

            return $row === false ? null : $row[0];
        });
    }

    /** All of the work or nothing; a failure of the work is passed on after the rollback. */
    public function inTransaction(Closure $work): void
    {
        $this->wrap(fn () => $this->pdo->beginTransaction());
        try {
            $work();
            $this->wrap(fn () => $this->pdo->commit());
        } catch (Throwable $failure) {
            try {
                if ($this->pdo->inTransaction()) {
                    $this->pdo->rollBack();
                }
            } catch (PDOException) {
                // The connection is gone: the server rolls back by itself, and the first failure is the one to tell.
            }
            throw $failure;
        }
    }

    /** @return list<int> numbers of the server's warnings and notes about the last statement */
    public function warnings(): array
    {
        return $this->wrap(function (): array {
            // As text: to prepare it on the server would be a statement of its own.
            $statement = $this->pdo->prepare('SHOW WARNINGS', [PDO::ATTR_EMULATE_PREPARES => true]);
            $statement->execute();

            return array_map(intval(...), array_column($statement->fetchAll(PDO::FETCH_ASSOC), 'Code'));
        });
    }

    /** PDO itself, for unbuffered reading. */
    public function pdo(): PDO
    {
        return $this->pdo;
    }

    /**
     * @template T
     * @param Closure(): T $work
     * @return T
     */
    public function wrap(Closure $work): mixed
    {
        return DatabaseFailure::wrap($this->server, $work);
    }

    /** @param array<int|string, int|float|string|null> $values */
    private function run(string $sql, array $values): PDOStatement
    {
        $statement = $this->pdo->prepare($sql);
        Statement::bind($statement, $values);
        $statement->execute();

        return $statement;
    }
}
