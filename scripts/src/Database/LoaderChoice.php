<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

use Msisf\Scripts\Exception\ExternalPartException;

/** Which bulk way to take. */
enum LoaderChoice: string
{
    /** LOAD DATA LOCAL where the server allows it, else INSERT. */
    case Auto = 'auto';
    case LocalFile = 'local-file';
    case Insert = 'insert';

    /** @throws ExternalPartException the server refuses the one that is asked for */
    public function loader(Connection $connection): RadiusLoader
    {
        if ($this === self::Insert) {
            return new InsertLoader($connection);
        }
        if ((int) $connection->value('SELECT @@local_infile') === 1) {
            return new LocalFileLoader($connection);
        }
        if ($this === self::LocalFile) {
            throw ExternalPartException::database(
                'the server does not allow LOAD DATA LOCAL (local_infile is off). Turn it on, or give --load=auto.'
            );
        }

        return new InsertLoader($connection);
    }
}
