namespace Msisf.Core.Render;

/// <summary>The renderer that makes an image.</summary>
public enum RendererKind
{
    /// <summary>POV-Ray, which draws the pattern files.</summary>
    PovRay,

    /// <summary>The program's own renderer, which draws the elevation model.</summary>
    Native,
}
