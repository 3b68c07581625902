<?php

declare(strict_types=1);

namespace Msisf\Tests\Integration;

use Msisf\Tests\Support\PrivateServer;

/** Wrong input, a wrong table, no access: one clear line, the thesis's exit codes, nothing changed. */
final class RefusedGenerationTest extends GenerationTestCase
{
    private const TILE = ['--lat=0:5', '--lon=0:5'];
    private const PASSWORD = 'geheim-7x!';

    /** @dataProvider wrongOptions */
    public function testWrongOrHostileOptionIsRefused(string $message, array $arguments): void
    {
        $repository = $this->folder->path('repository');

        self::assertRefused(1, $message, $this->generate(['--repository', $repository, ...$arguments]));

        self::assertDirectoryDoesNotExist($repository);
        self::assertSame(1036800, PrivateServer::shared()->value($this->environment, 'SELECT COUNT(*) FROM ldem_4'));
    }

    public static function wrongOptions(): array
    {
        return [
            'nothing asked for' => ['no tiles are named', []],
            'two ranges' => ['contradict each other', ['--all', '--lat=0:5']],
            'two wishes' => ['contradict each other', ['--all', '--resume', '--no-resume']],
            'resolution without products' => ['--res=5', ['--all', '--res=5']],
            'statement as resolution' => ['--res=4', ['--all', '--res=4; DROP TABLE ldem_4']],
            'statement as latitude' => ['--lat 0:5', ['--lat=0:5) OR 1=1; DELETE FROM ldem_4; --']],
            'statement as longitude' => ['--lon 0', ['--lon=0 UNION SELECT 1']],
            'statement as query' => ['--query=grid', ['--all', "--query=grid' OR '1'='1"]],
            'statement as margin' => ['--margin=0', ['--all', '--margin=0; DROP TABLE ldem_4']],
            'margin of a NaN' => ['--margin=NAN', ['--all', '--margin=NAN']],
            'margin above a degree' => ['--margin=1.01', ['--all', '--margin=1.01']],
            'statement as format' => ['--format=mesh2', ['--all', '--format=mesh2; --']],
            'statement as share' => ['--worker=1/2', ['--all', '--worker=1/2; --']],
            'no process' => ['--jobs=0', ['--all', '--jobs=0']],
            'latitude beyond the pole' => ['-90 to 90', ['--lat=80:100']],
            'unknown option' => ['--table is not an option', ['--all', '--table=ldem_4']],
            'a word' => ["'ldem_4' is not an option", ['--all', 'ldem_4']],
        ];
    }

    public function testRepositoryWithQuotesAndSemicolonsIsJustAName(): void
    {
        $repository = $this->folder->path("it's; DROP TABLE ldem_4; -- `\$(x)`");

        self::assertSame(0, $this->generate([...self::TILE, '--jobs=2', '--repository', $repository])->exitCode);

        self::assertFileExists("$repository/4/pattern_LDEM_4_lat_0_5_lon_0_5.inc");
        self::assertSame(1036800, PrivateServer::shared()->value($this->environment, 'SELECT COUNT(*) FROM ldem_4'));
    }

    public function testStatementAsDatabaseNameIsRefused(): void
    {
        $run = $this->generate(self::TILE, ['MSISF_DB_DATABASE' => 'msisf`; DROP TABLE ldem_4; --']);
        self::assertRefused(2, 'database name', $run);
    }

    public function testResolutionThatWasNotImportedIsRefused(): void
    {
        $run = $this->generate([...self::TILE, '--res=64', '--repository', $this->folder->path('r')]);
        self::assertRefused(2, 'Import it with ldem_mysql_insert.php', $run);
    }

    public function testDatabaseWithoutTablesIsRefused(): void
    {
        $empty = PrivateServer::shared()->freshDatabase();
        self::assertRefused(3, 'Import the elevation model first', $this->generate(self::TILE, $empty));
        self::assertRefused(3, 'Unknown database', $this->generate(self::TILE, ['MSISF_DB_DATABASE' => 'msisf_nowhere']));
    }

    /** @dataProvider incompleteImports */
    public function testIncompleteImportIsRefused(string $message, string $change): void
    {
        $environment = ImportedModels::oneTile();
        PrivateServer::shared()->execute($environment, $change);

        $run = $this->generate(['--lat=0:5', '--lon=350:355', '--repository', $this->folder->path('r')], $environment);

        self::assertRefused(2, $message, $run);
        self::assertSame([], $this->folder->files());
    }

    public static function incompleteImports(): array
    {
        return [
            'the record says so' => ['350 of 720 lines', "UPDATE ldem_import SET state = 'importing', rows_done = 350"],
            'being removed' => ['state removing', "UPDATE ldem_import SET state = 'removing'"],
            'of another format' => ['format 2', 'UPDATE ldem_import SET format_version = 2'],
            'a sample is missing' => ['only 440 of 441 samples', 'DELETE FROM ldem_4 WHERE row_index = 350 AND col_index = 1405'],
            'no record' => ['Import it with', 'DELETE FROM ldem_import'],
            'a hostile name' => ['without a proper name', "UPDATE ldem_import SET product_id = '*/ #include \"x\"'"],
        ];
    }

    public function testForeignFileUnderAPatternsNameIsRefusedAndStays(): void
    {
        $repository = $this->folder->path('r');
        mkdir("$repository/4", 0o777, true);
        $foreign = "$repository/4/pattern_LDEM_4_lat_0_5_lon_0_5.inc";
        file_put_contents($foreign, 'mesh { mine }');

        self::assertRefused(2, $foreign, $this->generate([...self::TILE, '--repository', $repository]));
        self::assertRefused(2, $foreign, $this->generate(['--lat=0:10', '--jobs=2', '--repository', $repository]));

        self::assertStringEqualsFile($foreign, 'mesh { mine }');
    }

    public function testRepositoryThatIsAFileIsRefused(): void
    {
        file_put_contents($this->folder->path('file'), '');
        $run = $this->generate([...self::TILE, '--repository', $this->folder->path('file')]);
        self::assertRefused(3, 'can\'t be made', $run);
    }

    public function testWrongPasswordIsRefusedWithoutShowingIt(): void
    {
        $run = $this->generate(self::TILE, ['MSISF_DB_USER' => 'nobody', 'MSISF_DB_PASSWORD' => self::PASSWORD]);
        self::assertRefused(3, 'Check user and password', $run);
        self::assertStringNotContainsString(self::PASSWORD, $run->errors);
    }

    public function testServerThatDoesNotRunIsRefused(): void
    {
        $run = $this->generate(self::TILE, ['MSISF_DB_SOCKET' => $this->folder->path('no.sock'), 'MSISF_DB_PASSWORD' => self::PASSWORD]);
        self::assertRefused(3, 'Is the server running', $run);
        self::assertStringNotContainsString(self::PASSWORD, $run->errors);
    }
}
