namespace Msisf.Core.Metadata;

/// <summary>The surface on which the points of a meta file's pixels lie.</summary>
public enum PixelSurface
{
    /// <summary>The reference sphere of thesis section 9.3.</summary>
    Sphere,

    /// <summary>The facets that the image shows.</summary>
    Terrain,
}
