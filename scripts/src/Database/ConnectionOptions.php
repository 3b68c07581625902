<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Console\Option;
use Msisf\Scripts\Console\ParsedOptions;

/** The options by which a script reaches the database. There is none for the password: arguments are seen by every user. */
final class ConnectionOptions
{
    /** @return list<Option> */
    public static function all(): array
    {
        return [
            Option::value('defaults-file', 'FILE', 'Option file of the MySQL client: host, port, socket, user, password, '
                . 'database and ssl-ca in its group [client]. What it leaves out comes from the environment: MSISF_DB_HOST, _PORT, '
                . '_SOCKET, _USER, _PASSWORD, _DATABASE, _SSL_CA.'),
        ];
    }

    public static function settings(ParsedOptions $options): ConnectionSettings
    {
        return ConnectionSettings::read($options->text('defaults-file'), getenv());
    }
}
