namespace Msisf.Adapters.Synthesis;

/// <summary>What a synthetic model has outside its region.</summary>
public enum SyntheticRest
{
    /// <summary>The base, interpolated; the detail fades out beyond the region's border.</summary>
    Base,

    /// <summary>The reference sphere: zeros, which a sparse file does not store.</summary>
    Flat,

    /// <summary>Nothing: the product is a part of the Moon, as those of NASA's split products.</summary>
    None,
}
