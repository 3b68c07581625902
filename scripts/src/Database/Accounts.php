<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\ExternalPartException;
use PDO;
use PDOException;
use SensitiveParameter;

/** Makes the database and the two users with the rights that the scripts need, and no more. */
final class Accounts
{
    public const IMPORT_USER = 'msisf_import';

    public const READ_USER = 'msisf_read';

    /** DROP and INDEX are for the tables of this database only; CREATE TEMPORARY TABLES for the sines on the server. */
    private const RIGHTS = [
        self::IMPORT_USER => 'SELECT, INSERT, UPDATE, DELETE, CREATE, DROP, INDEX, CREATE TEMPORARY TABLES',
        self::READ_USER => 'SELECT',
    ];

    /** What a server notes of IF NOT EXISTS: a database; a user on MariaDB, on MySQL. */
    private const EXISTS = [1007, 1973, 3163];

    public function __construct(private readonly Connection $connection)
    {
    }

    /** @return bool whether it is new */
    public function createDatabase(): bool
    {
        $this->connection->execute("CREATE DATABASE IF NOT EXISTS `{$this->connection->database}` CHARACTER SET utf8mb4");

        return $this->isNew();
    }

    /**
     * Makes a user, or leaves the one that is there with its password, and gives it its rights on the database.
     *
     * @return bool whether it is new
     * @param string $host from where it may come, e.g. "localhost", "10.1.%"
     * @throws BadInputException the host is none
     * @throws ExternalPartException the server refuses
     */
    public function createUser(string $user, string $host, #[SensitiveParameter] string $password): bool
    {
        if (preg_match('/^[0-9A-Za-z_.:%-]{1,60}$/D', $host) !== 1) {
            throw new BadInputException("--user-host=$host: a host name or address is needed, with % for any part.");
        }
        $account = "'$user'@'$host'";
        try {
            $quoted = $this->connection->pdo()->quote($password, PDO::PARAM_STR);
            $this->connection->pdo()->exec("CREATE USER IF NOT EXISTS $account IDENTIFIED BY $quoted");
        } catch (PDOException $exception) {
            // The server's own message may quote the statement, and so the password: it is not passed on.
            throw ExternalPartException::database("the user $account can't be made (error " . DatabaseFailure::number($exception)
                . '). Does this user have the right CREATE USER, and does the password fit the server\'s rules?');
        }
        $isNew = $this->isNew();
        // "_" in a database name would stand for any character here.
        $database = addcslashes($this->connection->database, '_');
        $this->connection->execute('GRANT ' . self::RIGHTS[$user] . " ON `$database`.* TO $account");

        return $isNew;
    }

    private function isNew(): bool
    {
        return array_intersect(self::EXISTS, $this->connection->warnings()) === [];
    }
}
