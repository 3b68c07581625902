namespace Msisf.Cli.Options;

/// <summary>Who draws the pictures.</summary>
internal enum RendererKind
{
    PovRay,
    Native,
}
