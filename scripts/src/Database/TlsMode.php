<?php

declare(strict_types=1);

namespace Msisf\Scripts\Database;

/** What is asked of the encryption of a connection. */
enum TlsMode: string
{
    /** Nothing is asked: PHP does not encrypt. */
    case Default = 'default';

    /** No encryption. */
    case Disabled = 'disabled';

    /** Encryption, without verifying the server. */
    case Required = 'required';

    /** Encryption with a certificate of a trusted authority that names the host. */
    case VerifyIdentity = 'verify-identity';
}
