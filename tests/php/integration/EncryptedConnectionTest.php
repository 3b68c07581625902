<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Tests\Support\CertificateAuthority;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\PrivateServer;
use Msisf\Tests\Support\ScriptRun;
use Msisf\Tests\Support\TemporaryFolder;
use PHPUnit\Framework\TestCase;

/** A server on the network, whose user may come by TLS only: what each option of TLS does with it. */
final class EncryptedConnectionTest extends TestCase
{
    private const PASSWORD = 'Tr0ub4dor-and-3';

    /** The database is empty: who reads this has logged in. */
    private const CONNECTED = 'Import the elevation model first';

    private const NOT_VERIFIED = 'Cannot connect to MySQL using SSL (error 2002). Does the server have TLS, does its certificate come from the '
        . 'authority in ssl-ca, and does it name the host?';

    private static ?TemporaryFolder $folder;

    private static ?PrivateServer $server;

    private static int $port;

    private static string $database;

    public static function setUpBeforeClass(): void
    {
        self::$folder = new TemporaryFolder();
        $own = new CertificateAuthority(self::$folder, 'own');
        new CertificateAuthority(self::$folder, 'other');
        $listener = stream_socket_server('tcp://127.0.0.1:0');
        self::$port = (int) substr((string) strrchr((string) stream_socket_get_name($listener, false), ':'), 1);
        fclose($listener);
        self::$server = PrivateServer::withNetwork([
            '--bind-address=127.0.0.1,127.0.0.2', '--port=' . self::$port,
            "--ssl-ca=$own->authority", "--ssl-cert=$own->certificate", "--ssl-key=$own->key",
        ]);
        $environment = self::$server->freshDatabase();
        self::$database = $environment['MSISF_DB_DATABASE'];
        foreach (['127.0.0.1', '127.0.0.2'] as $host) {
            self::$server->execute($environment, "CREATE USER me@'$host' IDENTIFIED BY '" . self::PASSWORD . "' REQUIRE SSL");
            self::$server->execute($environment, 'GRANT SELECT ON ' . self::$database . ".* TO me@'$host'");
        }
    }

    public static function tearDownAfterClass(): void
    {
        self::$server = null;
        self::$folder = null;
    }

    /** @dataProvider connections */
    public function testConnectionIsEncryptedAndVerifiedAsTheOptionsSay(array $options, string $message): void
    {
        $lines = ['host=127.0.0.1', 'port=' . self::$port, 'user=me', 'password=' . self::PASSWORD, 'database=' . self::$database, ...$options];
        $file = self::$folder->path('my.cnf');
        file_put_contents($file, str_replace('{folder}/', self::$folder->path(''), "[client]\n" . implode("\n", $lines) . "\n"));
        chmod($file, 0o600);

        $run = ScriptRun::start([PHP_BINARY, Parts::root() . '/scripts/generate_pattern.php', "--defaults-file=$file", '--all'])->wait();

        self::assertSame([3, ''], [$run->exitCode, $run->output], $run->errors);
        self::assertStringContainsString($message, $run->errors);
        self::assertMatchesRegularExpression('/^generate_pattern\.php: error: database [^:]+:' . self::$port . ': [^\n]+\n$/D', $run->errors);
        self::assertStringNotContainsString(self::PASSWORD, $run->errors);
    }

    public static function connections(): array
    {
        return [
            'not asked for' => [[], 'Access denied'],
            'declined' => [['ssl-mode=DISABLED'], 'Access denied'],
            'encrypted' => [['ssl-mode=REQUIRED'], self::CONNECTED],
            'encrypted, MariaDB\'s way' => [['ssl-verify-server-cert=0'], self::CONNECTED],
            'verified' => [['ssl-ca={folder}/own-ca.pem'], self::CONNECTED],
            'another authority' => [['ssl-ca={folder}/other-ca.pem'], self::NOT_VERIFIED],
            'authorities of the system' => [['ssl-mode=VERIFY_IDENTITY'], self::NOT_VERIFIED],
            'another name' => [['ssl-ca={folder}/own-ca.pem', 'host=127.0.0.2'], self::NOT_VERIFIED],
            'another name, not verified' => [['ssl-mode=REQUIRED', 'host=127.0.0.2'], self::CONNECTED],
        ];
    }
}
