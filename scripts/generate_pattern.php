<?php

declare(strict_types=1);

// Makes surface patterns of an elevation model that ldem_mysql_insert.php has put into the database (thesis, section 5.2).

use Msisf\Scripts\Console\Output;
use Msisf\Scripts\Console\ParsedOptions;
use Msisf\Scripts\Console\Program;
use Msisf\Scripts\Pattern\GeneratorOptions;
use Msisf\Scripts\Pattern\GeneratorProgram;

require __DIR__ . '/bootstrap.php';

exit(Program::run($argv, GeneratorOptions::parser(), static function (ParsedOptions $given, Output $output) use ($argv): void {
    $options = GeneratorOptions::read($given);
    $program = new GeneratorProgram($options, $output);
    if ($options->share === null) {
        $program->run($argv);
    } else {
        $program->work(...$options->share);
    }
}));
