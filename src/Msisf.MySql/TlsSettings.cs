namespace Msisf.MySql;

/// <summary>
/// The encryption of the connection, set by ssl-mode, ssl-ca and ssl-verify-server-cert; the PHP scripts follow the same rules.
/// </summary>
/// <param name="Mode">Required encryption.</param>
/// <param name="CertificateAuthority">PEM file of the trusted authority; null for the authorities of the system.</param>
public sealed record TlsSettings(TlsMode Mode, string? CertificateAuthority)
{
    /// <summary>
    /// The supported values of ssl-mode. VERIFY_CA is not supported, because PHP's PDO can't check a certificate without the host's name.
    /// </summary>
    private static readonly Dictionary<string, TlsMode> Modes = new(StringComparer.OrdinalIgnoreCase)
    {
        ["DISABLED"] = TlsMode.Disabled,
        ["REQUIRED"] = TlsMode.Required,
        ["VERIFY_IDENTITY"] = TlsMode.VerifyIdentity,
    };

    /// <summary>Reads the required encryption from the options; a given authority requires verification of the server.</summary>
    /// <param name="valueOf">Gets the value of an option; null if it is not given.</param>
    /// <exception cref="BadInputException">A value is wrong, or one option requires verification and another forbids it.</exception>
    internal static TlsSettings Read(Func<string, string?> valueOf)
    {
        TlsMode? mode = valueOf("ssl-mode") is string name ? ModeOf(name) : null;
        bool? verifies = valueOf("ssl-verify-server-cert") is string text ? IsOn(text) : null;
        string? authority = valueOf("ssl-ca");
        if (authority is not null && !File.Exists(authority))
        {
            throw new BadInputException($"ssl-ca {authority}: this file is missing. It holds the certificate of the authority, as PEM.");
        }

        bool asks = mode == TlsMode.VerifyIdentity || verifies == true || authority is not null;
        bool declines = mode is TlsMode.Disabled or TlsMode.Required || verifies == false;
        if (asks && declines)
        {
            throw new BadInputException(
                "ssl-mode, ssl-ca and ssl-verify-server-cert contradict each other: one asks to verify the server, another one not to. "
                + "Leave one of them out.");
        }

        TlsMode chosen = asks ? TlsMode.VerifyIdentity : mode ?? (declines ? TlsMode.Required : TlsMode.Default);
        return new TlsSettings(chosen, authority);
    }

    private static TlsMode ModeOf(string name) => Modes.TryGetValue(name, out TlsMode mode)
        ? mode
        : throw new BadInputException($"ssl-mode '{name}': one of {string.Join(", ", Modes.Keys)} is needed.");

    /// <summary>Whether a flag option is on; a name without a value means on, as for the clients.</summary>
    private static bool IsOn(string text) => text.ToUpperInvariant() switch
    {
        "" or "1" or "ON" or "TRUE" => true,
        "0" or "OFF" or "FALSE" => false,
        _ => throw new BadInputException($"ssl-verify-server-cert '{text}': 1 or 0 is needed."),
    };
}

/// <summary>The required encryption of a connection.</summary>
public enum TlsMode
{
    /// <summary>No requirement: the provider encrypts if the server supports it, and does not verify the server.</summary>
    Default,

    /// <summary>No encryption.</summary>
    Disabled,

    /// <summary>Encryption, without verifying the server.</summary>
    Required,

    /// <summary>Encryption with a certificate that names the host and is signed by a trusted authority.</summary>
    VerifyIdentity,
}
