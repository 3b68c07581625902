<?php

declare(strict_types=1);

namespace Msisf\Tests\Support;

use PDO;
use RuntimeException;

/** A MariaDB of the tests' own: own folder, own socket, no network unless asked for. Ends with the test run. */
final class PrivateServer
{
    private static ?self $shared = null;

    private readonly TemporaryFolder $folder;

    /** @var resource */
    private mixed $process;

    private int $databases = 0;

    /** @param list<string> $options how to be reached */
    private function __construct(private readonly array $options)
    {
        $this->folder = new TemporaryFolder();
        $install = ScriptRun::start([
            'mariadb-install-db', '--no-defaults', '--datadir=' . $this->folder->path('data'), '--user=' . self::account(),
            '--auth-root-authentication-method=normal', '--skip-test-db',
        ])->wait();
        if ($install->exitCode !== 0) {
            throw new RuntimeException($install->output . $install->errors);
        }
        // Before the first connection: the installation lets root in from 127.0.0.1, too.
        file_put_contents(
            $this->folder->path('init'),
            "DELETE FROM mysql.global_priv WHERE User = 'root' AND Host <> 'localhost'; FLUSH PRIVILEGES;\n",
        );
        $this->restart();
    }

    public function __destruct()
    {
        $this->kill();
    }

    public static function shared(): self
    {
        Parts::mariadbd();

        return self::$shared ??= new self(['--skip-networking']);
    }

    /** @param list<string> $options how to be reached; root may come by the socket only */
    public static function withNetwork(array $options): self
    {
        Parts::mariadbd();

        return new self([...$options, '--skip-name-resolve']);
    }

    /** @return array<string, string> the connection to a new, empty database */
    public function freshDatabase(): array
    {
        $environment = [
            'MSISF_DB_SOCKET' => $this->folder->path('socket'),
            'MSISF_DB_USER' => 'root',
            'MSISF_DB_DATABASE' => 'msisf_test_' . ++$this->databases,
        ];
        $this->connect()->exec("CREATE DATABASE {$environment['MSISF_DB_DATABASE']}");

        return $environment;
    }

    /** @param array<string, string> $environment of freshDatabase */
    public function execute(array $environment, string $sql): void
    {
        $this->connect($environment['MSISF_DB_DATABASE'])->exec($sql);
    }

    /** @param array<string, string> $environment of freshDatabase */
    public function value(array $environment, string $sql): mixed
    {
        return $this->connect($environment['MSISF_DB_DATABASE'])->query($sql)->fetchColumn();
    }

    /**
     * A transaction left open after this statement: its rows bar the way of whoever writes the same, until rollBack(), or
     * until the last reference to the connection is gone.
     *
     * @param array<string, string> $environment of freshDatabase
     */
    public function hold(array $environment, string $sql): PDO
    {
        $connection = $this->connect($environment['MSISF_DB_DATABASE']);
        $connection->beginTransaction();
        $connection->exec($sql);

        return $connection;
    }

    /** Ends the server as a power cut does. */
    public function kill(): void
    {
        proc_terminate($this->process, 9);
        $deadline = hrtime(true) + 60_000_000_000;
        while (proc_get_status($this->process)['running']) {
            if (hrtime(true) > $deadline) {
                throw new RuntimeException('mariadbd did not end within 60 s of its SIGKILL');
            }
            usleep(2000);
        }
    }

    /** Starts the server, and waits until it answers. */
    public function restart(): void
    {
        $log = ['file', $this->folder->path('log'), 'a'];
        $this->process = proc_open([
            Parts::mariadbd(), '--no-defaults', '--user=' . self::account(), '--datadir=' . $this->folder->path('data'),
            '--socket=' . $this->folder->path('socket'), '--pid-file=' . $this->folder->path('pid'), ...$this->options,
            '--init-file=' . $this->folder->path('init'), '--local-infile=1', '--innodb-buffer-pool-size=512M', '--innodb-log-file-size=128M', '--innodb-flush-log-at-trx-commit=2',
        ], [['file', '/dev/null', 'r'], $log, $log], $pipes);
        $deadline = hrtime(true) + 60_000_000_000;
        while (true) {
            try {
                $this->connect();

                return;
            } catch (\PDOException $exception) {
                if (hrtime(true) > $deadline) {
                    throw new RuntimeException((string) file_get_contents($this->folder->path('log')), 0, $exception);
                }
                usleep(20_000);
            }
        }
    }

    private function connect(?string $database = null): PDO
    {
        $name = 'mysql:unix_socket=' . $this->folder->path('socket') . ($database === null ? '' : ";dbname=$database");

        return new PDO($name, 'root', '', [PDO::ATTR_ERRMODE => PDO::ERRMODE_EXCEPTION, PDO::ATTR_EMULATE_PREPARES => false]);
    }

    private static function account(): string
    {
        return posix_getpwuid(posix_geteuid())['name'];
    }
}
