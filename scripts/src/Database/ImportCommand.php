<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Console\Option;
use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Console\ParsedOptions;
use Msisf\Scripts\Exception\UsageException;
use Msisf\Scripts\Ldem\LdemImage;
use Msisf\Scripts\Ldem\LdemLabelReader;

/** What ldem_mysql_insert.php does: make the database, import products, prove that they are there. */
final class ImportCommand
{
    private const PASSWORDS = [
        Accounts::IMPORT_USER => 'MSISF_DB_IMPORT_PASSWORD',
        Accounts::READ_USER => 'MSISF_DB_READ_PASSWORD',
    ];

    public function __construct(private readonly ParsedOptions $options, private readonly Output $output)
    {
    }

    /** @return list<Option> */
    public static function options(): array
    {
        return [
            ...ConnectionOptions::all(),
            Option::flag('create', 'Make the database, its tables, and the users ' . implode(' and ', array_keys(self::PASSWORDS))
                . ' whose passwords stand in ' . implode(' and ', self::PASSWORDS) . ' (needs an administrator\'s account).'),
            Option::value('user-host', 'HOST', 'With --create: from where the users may come.', 'localhost'),
            Option::flag(
                'replace',
                'Delete what is in the table of another version of the product, or of overlapping products; import a complete one anew.',
            ),
            Option::flag('verify', 'Import nothing: compare every row in the table with the file.'),
            Option::value('load', 'WAY', 'Bulk way: auto, local-file or insert. auto asks the server.', LoaderChoice::Auto->value),
            Option::value('wait', 'SECONDS', 'How long to wait for another import into the same table.', '600'),
        ];
    }

    public function run(): void
    {
        $this->checkOptions();
        $load = LoaderChoice::from($this->options->choice('load', array_column(LoaderChoice::cases(), 'value')));
        $patienceSeconds = $this->options->integer('wait', 0, 86400);
        // All labels first: a wrong one is found before hours of work with the others.
        $images = array_map(
            static fn (string $path): LdemImage => LdemImage::open(LdemLabelReader::readFile($path)),
            $this->options->operands
        );
        $settings = ConnectionOptions::settings($this->options);
        $settings->warn($this->output);
        $connection = Connection::open($settings, $load !== LoaderChoice::Insert);
        if ($this->options->has('create')) {
            $this->create($connection);
        }
        $connection->useDatabase();
        foreach ($images as $image) {
            if ($this->options->has('verify')) {
                $sha256 = (new LdemVerifier($connection, $this->output))->verify($image);
                $this->output->result("{$image->label->productId} $sha256");
            } else {
                $importer = new LdemImporter($connection, $this->output, $load->loader(...));
                $record = $importer->import($image, $this->options->has('replace'), $patienceSeconds);
                $this->output->result("$record->table $record->productId {$record->samplesDone()} rows");
            }
        }
    }

    private function checkOptions(): void
    {
        if ($this->options->operands === [] && !$this->options->has('create')) {
            throw new UsageException('no label is given. Name the .LBL files of the products; --help shows how.');
        }
        if ($this->options->has('verify') && ($this->options->has('replace') || $this->options->has('create'))) {
            throw new UsageException(
                '--verify changes nothing: it goes neither with --create nor with --replace. Run them one after the other.',
            );
        }
    }

    private function create(Connection $connection): void
    {
        $accounts = new Accounts($connection);
        $this->tellMade("database $connection->database", $accounts->createDatabase());
        $connection->useDatabase();
        (new Schema($connection))->createImports();
        $host = $this->options->requiredText('user-host');
        foreach (self::PASSWORDS as $user => $variable) {
            $password = getenv($variable);
            if ($password === false || $password === '') {
                $this->output->notice("no user $user is made: $variable is not set");
            } else {
                $this->tellMade("user '$user'@'$host'", $accounts->createUser($user, $host, $password));
            }
        }
    }

    private function tellMade(string $what, bool $isNew): void
    {
        if ($isNew) {
            $this->output->result("$what made");
        } else {
            $this->output->notice("$what was there and stays as it is");
        }
    }
}
