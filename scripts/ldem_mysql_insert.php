<?php

declare(strict_types=1);

use Msisf\Scripts\Console\OptionParser;
use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Console\ParsedOptions;
use Msisf\Scripts\Console\Program;
use Msisf\Scripts\Database\ImportCommand;

require __DIR__ . '/bootstrap.php';

$usage = <<<'TEXT'
Imports elevation models of the Moon (NASA's LDEM products) into a MySQL or MariaDB database.

    php ldem_mysql_insert.php --defaults-file FILE LABEL...

LABEL is the .LBL file of a product in simple cylindrical projection; its image lies beside it. An import that was
interrupted goes on where it stopped when it is run again. Results are on stdout, a line a product. docs/database.md
describes the tables and says how long it takes.

Exit codes: 0 done, 1 wrong options, 2 a file or the table does not hold what it should, 3 the database failed, 70 a bug.
TEXT;

$parser = new OptionParser($usage, ImportCommand::options(), 'LABEL');
exit(Program::run($argv, $parser, static function (ParsedOptions $options, Output $output): void {
    (new ImportCommand($options, $output))->run();
}));
