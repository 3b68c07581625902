<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Exception\BadInputException;
use Msisf\Scripts\Exception\UsageException;
use SensitiveParameter;

/** Where the database is and who asks, read as msis reads it (docs/database.md). The password is in no message, dump or trace. */
final class ConnectionSettings
{
    /** Where servers put their socket: Debian's packages, Red Hat's, and a server built from source or on macOS. */
    public const DEFAULT_SOCKETS = ['/run/mysqld/mysqld.sock', '/var/lib/mysql/mysql.sock', '/tmp/mysql.sock'];

    /** Options that mean something when their value is empty. */
    private const MAY_BE_EMPTY = ['password', 'ssl-verify-server-cert'];

    private const DEFAULT_DATABASE = 'msisf';

    private const LOCAL_HOST = 'localhost';

    private function __construct(
        public readonly string $host,
        public readonly ?int $port,
        public readonly ?string $socket,
        public readonly string $user,
        #[SensitiveParameter]
        private readonly string $password,
        public readonly string $database,
        public readonly TlsSettings $tls,
    ) {
    }

    /**
     * What the option file says; what it leaves out comes from the environment: MSISF_DB_HOST, _PORT, _SOCKET, ..., _SSL_CA.
     *
     * @param string|null $optionFile path of a file with a [client] group, as the mysql client reads; null if none is given
     * @param array<string, string> $environment
     * @throws BadInputException the file or a value is wrong
     * @throws UsageException nothing names a user
     */
    public static function read(?string $optionFile, #[SensitiveParameter] array $environment): self
    {
        $values = $optionFile === null ? [] : OptionFile::read($optionFile);
        foreach (OptionFile::KNOWN as $name) {
            if (($values[$name] ?? '') === '' && !(isset($values[$name]) && in_array($name, self::MAY_BE_EMPTY, true))) {
                $variable = $environment['MSISF_DB_' . strtoupper(strtr($name, '-', '_'))] ?? '';
                $values[$name] = $variable === '' ? null : $variable;
            }
        }

        return self::of($values);
    }

    /**
     * The first that is there; the first of all if none is.
     *
     * @param non-empty-list<string> $places
     */
    public static function defaultSocket(array $places): string
    {
        foreach ($places as $place) {
            if (file_exists($place)) {
                return $place;
            }
        }

        return $places[0];
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

    /** For messages: the socket, or host and port. */
    public function server(): string
    {
        return $this->socket ?? $this->host . ($this->port === null ? '' : ":$this->port");
    }

    /** Tells the user if another computer could answer in the server's place. */
    public function warn(Output $output): void
    {
        if ($this->isUnverified()) {
            $output->notice("the server {$this->server()} is not verified, nor is the connection encrypted: no ssl-ca says who may answer"
                . ' (docs/database.md, TLS)');
        }
    }

    /** Whether the server is on another computer and no option says whether to verify it. */
    public function isUnverified(): bool
    {
        return $this->socket === null && $this->tls->mode === TlsMode::Default && $this->host !== self::LOCAL_HOST
            && preg_match('/^(?:127\.[0-9.]+|::1)$/D', $this->host) !== 1;
    }

    /** @return array<string, mixed> */
    public function __debugInfo(): array
    {
        return ['server' => $this->server(), 'user' => $this->user, 'database' => $this->database];
    }

    /** @param array<string, string|null> $values by the names of OptionFile::KNOWN */
    private static function of(#[SensitiveParameter] array $values): self
    {
        $user = $values['user'] ?? throw new UsageException(
            'no database user. Give --defaults-file FILE with a [client] group, or set MSISF_DB_USER and MSISF_DB_PASSWORD.'
        );
        $database = $values['database'] ?? self::DEFAULT_DATABASE;
        if (preg_match('/^[0-9A-Za-z_]{1,64}$/D', $database) !== 1) {
            throw new BadInputException('database name \'' . self::shown($database) . "': 1 to 64 letters, digits or '_' are needed.");
        }
        $host = self::host($values['host'] ?? self::LOCAL_HOST);
        $port = self::port($values['port']);
        $socket = self::socket($values['socket'], $host, $port);
        $tls = TlsSettings::of($values['ssl-mode'], $values['ssl-ca'], $values['ssl-verify-server-cert'] ?? null);
        if ($socket !== null && $tls->pdoOptions() !== []) {
            throw new BadInputException("ssl options are for a server on the network, and this is the socket $socket. "
                . 'Leave them out, or give the host by another name than localhost.');
        }

        return new self($host, $port, $socket, $user, $values['password'] ?? '', $database, $tls);
    }

    /** As for the clients, localhost is the socket; Windows has none. */
    private static function socket(?string $named, string $host, ?int $port): ?string
    {
        if ($named !== null) {
            if (preg_match('/[;\x00-\x1f\x7f]/', $named) === 1) {
                throw new BadInputException('database socket: no semicolon or control character can be in its path.');
            }
            if ($host !== self::LOCAL_HOST) {
                throw new BadInputException("database host '$host' and socket '$named' contradict each other. Leave one of them out.");
            }

            return $named;
        }
        if ($host !== self::LOCAL_HOST || PHP_OS_FAMILY === 'Windows') {
            return null;
        }
        if ($port !== null) {
            throw new BadInputException("database port $port: localhost is the server's socket, which has no port. "
                . 'Give host=127.0.0.1, or leave the port out.');
        }

        return self::defaultSocket(self::DEFAULT_SOCKETS);
    }

    private static function host(string $text): string
    {
        if (preg_match('/^[0-9A-Za-z_.:%-]{1,255}$/D', $text) !== 1) {
            throw new BadInputException('database host \'' . self::shown($text) . "': the name or address of one host is needed.");
        }

        return strtolower($text) === self::LOCAL_HOST ? self::LOCAL_HOST : $text;
    }

    private static function port(?string $text): ?int
    {
        if ($text === null) {
            return null;
        }
        if (preg_match('/^[0-9]{1,5}$/D', $text) !== 1 || (int) $text < 1 || (int) $text > 65535) {
            throw new BadInputException('database port \'' . self::shown($text) . "': a number from 1 to 65535 is needed.");
        }

        return (int) $text;
    }

    private static function shown(string $text): string
    {
        return addcslashes($text, "\0..\37");
    }
}
