<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Tests\Support\LabelText;
use Msisf\Tests\Support\Parts;
use Msisf\Tests\Support\ScriptRun;

/** What can't be imported: a message that says why, the right exit code, nothing changed, and never a password. */
final class RefusedImportTest extends ImportTestCase
{
    private const PASSWORD = 'Tr0ub4dor-and-3';

    /** @dataProvider wrongOptions */
    public function testImportWrongOptionsAreRefused(array $arguments, string $message): void
    {
        self::assertRefused(1, $message, $this->import($arguments));
    }

    public static function wrongOptions(): array
    {
        return [
            'nothing' => [[], 'no label is given'],
            'a password' => [['--password=x', 'a.LBL'], '--password is not an option'],
            'bulk way' => [['--load=fast', 'a.LBL'], '--load=fast: one of auto, local-file, insert is needed'],
            'SQL as a number' => [['--wait=0); DROP TABLE ldem_import; --', 'a.LBL'], 'a whole number from 0 to 86400 is needed'],
            'verify and replace' => [['--verify', '--replace', 'a.LBL'], '--verify changes nothing'],
        ];
    }

    public function testImportHelpIsOnStdout(): void
    {
        $run = $this->import(['--help']);
        self::assertDone($run);
        self::assertStringContainsString('--defaults-file FILE', $run->output);
        self::assertSame('', $run->errors);
    }

    /** @dataProvider hostileNames */
    public function testImportNamesThatAreSqlAreOnlyNames(string $file): void
    {
        $label = $this->smallProduct();
        $hostile = $this->folder->path($file);
        copy($label, $hostile);
        $run = $this->import([$hostile]);
        self::assertDone($run);
        self::assertSame("800", explode(' ', $this->checksum())[0]);
        self::assertRefused(2, 'missing, or can\'t be read', $this->import([$this->folder->path("no-$file")]));
    }

    public static function hostileNames(): array
    {
        return [["'; DROP TABLE ldem_4; --.LBL"], ['`ldem_4` (x.LBL'], ["a\\'b\".LBL"], ['%s:x?.LBL']];
    }

    public function testImportProductIdWithSqlIsRefused(): void
    {
        $label = LabelText::writeProduct($this->folder, 'X', [20, 15, 30, 40], LabelText::samples(800));
        file_put_contents($label, str_replace('PRODUCT_ID = "X"', 'PRODUCT_ID = "X\'); DROP TABLE ldem_import; --"', (string) file_get_contents($label)));
        self::assertRefused(2, '1 to 40 letters, digits', $this->import([$label]));
    }

    public function testImportLabelThatLiesAboutItsSizeIsRefused(): void
    {
        $label = LabelText::writeProduct($this->folder, 'SHORT', [20, 15, 30, 40], LabelText::samples(799));
        self::assertRefused(2, 'SHORT.IMG: 1598 bytes, 1600 expected', $this->import([$label]));
        self::assertSame(0, $this->value('SELECT COUNT(*) FROM information_schema.tables WHERE table_schema = DATABASE()'));
    }

    public function testImportResolutionWithoutTableIsRefused(): void
    {
        $label = LabelText::writeProduct($this->folder, 'TWO', [20, 15, 30, 40], LabelText::samples(200), [
            'MAP_RESOLUTION' => '2 <pix/deg>', 'LINES' => '10', 'LINE_SAMPLES' => '20', 'FILE_RECORDS' => '10', 'RECORD_BYTES' => '40',
            'LINE_PROJECTION_OFFSET' => '39.5', 'SAMPLE_PROJECTION_OFFSET' => '299.5',
        ]);
        self::assertRefused(2, 'resolution 2 px/deg: one of 4, 16, 32, 64, 128, 256, 512, 1024 is needed', $this->import([$label]));
    }

    public function testImportWrongValueInTheMiddleStopsThere(): void
    {
        $label = LabelText::writeProduct($this->folder, 'BAD', [20, 15, 30, 40], substr_replace(LabelText::samples(800), "\0\x80", 1000, 2));
        self::assertRefused(2, 'line 13, sample 21: the value -32768 is outside', $this->import([$label]));
    }

    public function testImportChangedImageUnderTheSameNameIsNoticed(): void
    {
        self::assertDone($this->import([$this->smallProduct(seed: 1)]));
        $before = $this->checksum();
        $label = $this->smallProduct(seed: 2);
        self::assertRefused(2, 'SMALL: the image has changed since it was imported. Import it with --replace', $this->import([$label]));
        self::assertSame($before, $this->checksum());
        self::assertRefused(2, 'is not the one that was imported', $this->import(['--verify', $label]));
        self::assertDone($this->import(['--replace', $label]));
        self::assertNotSame($before, $this->checksum());
        self::assertDone($this->import(['--verify', $label]));
    }

    public function testImportOverlappingProductIsRefusedOrReplacesTheOther(): void
    {
        self::assertDone($this->import([$this->smallProduct()]));
        $neighbour = LabelText::writeProduct($this->folder, 'NEIGHBOUR', [20, 15, 40, 50], LabelText::samples(800, 3));
        self::assertDone($this->import([$neighbour]));
        $other = LabelText::writeProduct($this->folder, 'OTHER', [25, 15, 35, 40], LabelText::samples(800, 4));
        self::assertRefused(2, 'OTHER: ldem_4 has SMALL there already', $this->import([$other]));
        self::assertDone($this->import(['--replace', $other]));
        self::assertDone($this->import(['--verify', $other, $neighbour]));
        self::assertSame(1600, $this->value('SELECT COUNT(*) FROM ldem_4'));
    }

    public function testImportRemovalThatWasInterruptedIsCompleted(): void
    {
        $label = $this->smallProduct();
        self::assertDone($this->import([$label]));
        $this->execute("UPDATE ldem_import SET state = 'removing'");
        $this->execute('DELETE FROM ldem_4 WHERE row_index % 3 = 0');
        self::assertDone($this->import([$label]));
        self::assertDone($this->import(['--verify', $label]));
    }

    public function testImportRowsOfSomebodyElseInTheWaySayHowToMendIt(): void
    {
        $label = $this->smallProduct();
        self::assertDone($this->import([$label]));
        $this->execute("UPDATE ldem_import SET state = 'importing', rows_done = 10");
        self::assertRefused(2, '10 of 20 lines of SMALL are imported', $this->import(['--verify', $label]));
        self::assertRefused(3, 'drop it, and import its products again', $this->import([$label]));
        $this->execute('DROP TABLE ldem_4');
        self::assertDone($this->import([$label]));
        self::assertDone($this->import(['--verify', $label]));
    }

    public function testImportTableThatWasDroppedIsFilledAgain(): void
    {
        $label = $this->smallProduct();
        self::assertDone($this->import([$label]));
        $this->execute('DROP TABLE ldem_4');
        self::assertDone($this->import([$label]));
        self::assertDone($this->import(['--verify', $label]));
    }

    public function testImportTableOfSomebodyElseIsLeftAlone(): void
    {
        $this->execute('CREATE TABLE ldem_4 (point_id BIGINT PRIMARY KEY, lat DOUBLE)');
        self::assertRefused(2, 'its table ldem_4 was not made by this script', $this->import([$this->smallProduct()]));
        self::assertSame('lat', $this->value("SELECT column_name FROM information_schema.columns WHERE table_schema = DATABASE() AND table_name = 'ldem_4' AND ordinal_position = 2"));
    }

    /** @dataProvider tamperings */
    public function testVerifyAnyDifferenceIsFound(string $sql, string $message): void
    {
        $label = $this->smallProduct();
        self::assertDone($this->import([$label]));
        $this->execute($sql);
        self::assertRefused(2, $message, $this->import(['--verify', $label]));
        self::assertDone($this->import(['--replace', $label]));
        self::assertDone($this->import(['--verify', $label]));
    }

    public static function tamperings(): array
    {
        return [
            'last bit of x' => ['UPDATE ldem_4 SET x = x * (1e0 + 2.3e-16) WHERE row_index = 285 AND col_index = 150', 'row_index 285, col_index 150: x is'],
            'point' => ['UPDATE ldem_4 SET `point` = POINT(1, 2) WHERE row_index = 299 AND col_index = 159', 'row_index 299, col_index 159: point is'],
            'missing row' => ['DELETE FROM ldem_4 WHERE row_index = 281 AND col_index = 120', 'row_index 281: 39 rows of SMALL, 40 expected'],
            'row of nothing' => ['INSERT INTO ldem_4 SELECT 0, 0, 0, 0, 0, 0, 0, 0, POINT(0, 0)', 'ldem_4: 801 rows, 800 expected'],
        ];
    }

    /** @dataProvider columns */
    public function testVerifyColumnThatWasChangedIsDamage(string $change, string $message): void
    {
        $label = $this->smallProduct();
        self::assertDone($this->import([$label]));
        $this->execute('ALTER TABLE ldem_4 DROP KEY point_index');
        $this->execute("ALTER TABLE ldem_4 $change");
        self::assertRefused(2, "ldem_4 is damaged: $message. Drop it, and import its products again.", $this->import(['--verify', $label]));
        $this->execute('DROP TABLE ldem_4');
        self::assertDone($this->import([$label]));
        self::assertDone($this->import(['--verify', $label]));
    }

    public static function columns(): array
    {
        return [
            'no point' => ['DROP COLUMN `point`', 'it has no column point'],
            'point in bytes' => ['MODIFY `point` LONGBLOB NOT NULL', "its column point is of the type 'longblob', 'point' expected"],
            'any geometry' => ['MODIFY `point` GEOMETRY NOT NULL', "its column point is of the type 'geometry', 'point' expected"],
            'point that may be missing' => ['MODIFY `point` POINT NULL', "its column point is of the type 'point or NULL', 'point' expected"],
            'no radius' => ['DROP COLUMN planetary_radius', 'it has no column planetary_radius'],
            'single precision' => ['MODIFY x FLOAT NOT NULL', "its column x is of the type 'float', 'double' expected"],
        ];
    }

    public function testImportLocalInfileOffTakesTheOtherWay(): void
    {
        $this->execute('SET GLOBAL local_infile = OFF');
        try {
            $run = $this->import([$this->smallProduct()]);
            self::assertDone($run);
            self::assertStringContainsString('by INSERT of 5000 rows', $run->errors);
            self::assertRefused(3, 'local_infile is off', $this->import(['--load=local-file', '--replace', $this->smallProduct(seed: 2)]));
        } finally {
            $this->execute('SET GLOBAL local_infile = ON');
        }
    }

    public function testImportWrongPasswordIsRefusedWithoutIt(): void
    {
        $run = $this->import([$this->smallProduct()], ['MSISF_DB_USER' => 'nobody-here', 'MSISF_DB_PASSWORD' => self::PASSWORD]);
        self::assertRefused(3, 'Access denied', $run);
        self::assertStringContainsString('Check user and password', $run->errors);
        self::assertStringNotContainsString(self::PASSWORD, $run->errors . $run->output);
    }

    public function testImportNoServerSaysWhere(): void
    {
        $run = $this->import([$this->smallProduct()], ['MSISF_DB_SOCKET' => $this->folder->path('none'), 'MSISF_DB_PASSWORD' => self::PASSWORD]);
        self::assertRefused(3, 'Is the server running', $run);
        self::assertStringContainsString($this->folder->path('none'), $run->errors);
        self::assertStringNotContainsString(self::PASSWORD, $run->errors);
    }

    public function testVerifyTableThatWasDroppedSaysToImportIt(): void
    {
        $label = $this->smallProduct();
        self::assertDone($this->import([$label]));
        $this->execute('DROP TABLE ldem_4');
        self::assertRefused(3, "doesn't exist (error 1146). Import the elevation model first", $this->import(['--verify', $label]));
    }

    public function testImportOtherServiceOnThePortIsNamed(): void
    {
        $listener = stream_socket_server('tcp://127.0.0.1:0');
        $address = (string) stream_socket_get_name($listener, false);
        $run = $this->start([$this->smallProduct()], ['MSISF_DB_HOST' => '127.0.0.1', 'MSISF_DB_SOCKET' => '', 'MSISF_DB_PORT' => substr($address, 10)]);
        $client = stream_socket_accept($listener, 30);
        fwrite($client, "SSH-2.0-OpenSSH_9.2\r\n");
        fclose($client);
        self::assertRefused(3, "database $address: ", $run->wait());
        self::assertStringContainsString('Is it a MySQL or MariaDB server that answers there? Check host and port.', $run->errors);
    }

    public function testImportNoDatabaseSaysHowToMakeIt(): void
    {
        $run = $this->import([$this->smallProduct()], ['MSISF_DB_DATABASE' => 'never_made']);
        self::assertRefused(3, "Unknown database 'never_made'", $run);
        self::assertStringContainsString('--create', $run->errors);
    }

    public function testCreateMakesUsersWithLeastRights(): void
    {
        $database = $this->environment['MSISF_DB_DATABASE'] . '_new';
        $passwords = ['MSISF_DB_IMPORT_PASSWORD' => self::PASSWORD, 'MSISF_DB_READ_PASSWORD' => self::PASSWORD . "'\\"];
        $created = $this->import(['--create'], ['MSISF_DB_DATABASE' => $database, ...$passwords]);
        self::assertDone($created);
        self::assertSame("database $database made\nuser 'msisf_import'@'localhost' made\nuser 'msisf_read'@'localhost' made\n", $created->output);
        $again = $this->import(['--create'], ['MSISF_DB_DATABASE' => $database, ...$passwords]);
        self::assertDone($again);
        self::assertSame('', $again->output);
        self::assertStringContainsString("database $database was there and stays as it is", $again->errors);
        self::assertStringContainsString("user 'msisf_read'@'localhost' was there and stays as it is", $again->errors);
        try {
            $importer = $this->optionFile($database, 'msisf_import', self::PASSWORD);
            $reader = $this->optionFile($database, 'msisf_read', self::PASSWORD . "'\\\\");
            $label = $this->smallProduct();
            self::assertDone($this->asUserOf($importer, $label));
            self::assertDone($this->asUserOf($reader, '--verify', $label));
            $refused = $this->asUserOf($reader, '--replace', $this->smallProduct(seed: 2));
            self::assertRefused(3, 'denied to user \'msisf_read\'', $refused);
            self::assertStringContainsString('docs/database.md lists those that are needed', $refused->errors);
            $elsewhere = $this->optionFile($database . 'x', 'msisf_import', self::PASSWORD);
            self::assertRefused(3, 'Access denied', $this->asUserOf($elsewhere, '--create'));
            self::assertStringNotContainsString(self::PASSWORD, $created->errors . $refused->errors);
        } finally {
            $this->execute("DROP USER msisf_import@localhost, msisf_read@localhost");
            $this->execute("DROP DATABASE $database");
        }
    }

    public function testCreatePasswordThatTheServerRefusesIsNotShown(): void
    {
        $run = $this->import(['--create', '--user-host=a b'], ['MSISF_DB_IMPORT_PASSWORD' => self::PASSWORD]);
        self::assertRefused(2, '--user-host=a b', $run);
        $this->execute("CREATE USER few@localhost IDENTIFIED BY 'x'; ");
        $this->execute('GRANT CREATE ON *.* TO few@localhost');
        $run = $this->import(['--create'], ['MSISF_DB_IMPORT_PASSWORD' => self::PASSWORD, 'MSISF_DB_USER' => 'few', 'MSISF_DB_PASSWORD' => 'x']);
        $this->execute('DROP USER few@localhost');
        self::assertRefused(3, "the user 'msisf_import'@'localhost' can't be made", $run);
        self::assertStringNotContainsString(self::PASSWORD, $run->errors);
    }

    private function asUserOf(string $optionFile, string ...$arguments): ScriptRun
    {
        $script = Parts::root() . '/scripts/ldem_mysql_insert.php';

        return ScriptRun::start([PHP_BINARY, $script, "--defaults-file=$optionFile", ...$arguments])->wait();
    }

    private function optionFile(string $database, string $user, string $escapedPassword): string
    {
        $path = $this->folder->path("$user.cnf");
        file_put_contents($path, "[client]\nsocket={$this->environment['MSISF_DB_SOCKET']}\nuser=$user\npassword=\"$escapedPassword\"\ndatabase=$database\n");
        chmod($path, 0o600);

        return $path;
    }
}
