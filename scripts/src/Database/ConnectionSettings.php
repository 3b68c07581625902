<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\UsageException;
use SensitiveParameter;

/** Where the database is and who asks. The password is in no message, dump or trace. */
final class ConnectionSettings
{
    private const VARIABLES = [
        'host' => 'MSISF_DB_HOST',
        'port' => 'MSISF_DB_PORT',
        'socket' => 'MSISF_DB_SOCKET',
        'user' => 'MSISF_DB_USER',
        'password' => 'MSISF_DB_PASSWORD',
        'database' => 'MSISF_DB_DATABASE',
    ];

    private const DEFAULT_DATABASE = 'msisf';

    private function __construct(
        public readonly string $host,
        public readonly ?int $port,
        public readonly ?string $socket,
        public readonly string $user,
        #[SensitiveParameter]
        private readonly string $password,
        public readonly string $database,
    ) {
    }

    /**
     * What the option file says; what it leaves out comes from the environment.
     *
     * @param string|null $optionFile path of a file with a [client] group, as the mysql client reads; null if none is given
     * @param array<string, string> $environment
     * @throws BadInputException the file or a value is wrong
     * @throws UsageException nothing names a user
     */
    public static function read(?string $optionFile, #[SensitiveParameter] array $environment): self
    {
        $values = $optionFile === null ? [] : OptionFile::read($optionFile);
        foreach (self::VARIABLES as $name => $variable) {
            $values[$name] ??= $environment[$variable] ?? null;
        }

        return self::of($values);
    }

    public function password(): string
    {
        return $this->password;
    }

    /** PDO's data source name, without the database: it need not exist yet. */
    public function dataSource(): string
    {
        $server = $this->socket === null
            ? "host=$this->host" . ($this->port === null ? '' : ";port=$this->port")
            : "unix_socket=$this->socket";

        return "mysql:$server;charset=utf8mb4";
    }

    /** For messages. */
    public function server(): string
    {
        return $this->socket ?? $this->host . ($this->port === null ? '' : ":$this->port");
    }

    /** @return array<string, mixed> */
    public function __debugInfo(): array
    {
        return ['server' => $this->server(), 'user' => $this->user, 'database' => $this->database];
    }

    /** @param array<string, string|null> $values */
    private static function of(#[SensitiveParameter] array $values): self
    {
        $user = $values['user'] ?? throw new UsageException(
            'no database user. Give --defaults-file FILE with a [client] group, or set MSISF_DB_USER and MSISF_DB_PASSWORD.'
        );
        $host = $values['host'] ?? 'localhost';
        $socket = $values['socket'] ?? null;
        foreach (['host' => $host, 'socket' => $socket ?? ''] as $name => $text) {
            // A semicolon would begin another part of PDO's data source name.
            if (preg_match('/[;\x00-\x1f]/', $text) === 1) {
                throw new BadInputException(
                    "database $name '" . addcslashes($text, "\0..\37") . "': no semicolon or control character can be in it.",
                );
            }
        }
        $database = $values['database'] ?? self::DEFAULT_DATABASE;
        if (preg_match('/^[0-9A-Za-z_]{1,64}$/D', $database) !== 1) {
            throw new BadInputException(
                'database name \'' . addcslashes($database, "\0..\37") . "': 1 to 64 letters, digits or '_' are needed.",
            );
        }

        return new self($host, self::port($values['port'] ?? null), $socket, $user, $values['password'] ?? '', $database);
    }

    private static function port(?string $text): ?int
    {
        if ($text === null) {
            return null;
        }
        if (preg_match('/^[0-9]{1,5}$/D', $text) !== 1 || (int) $text < 1 || (int) $text > 65535) {
            throw new BadInputException('database port \'' . addcslashes($text, "\0..\37") . "': a number from 1 to 65535 is needed.");
        }

        return (int) $text;
    }
}
